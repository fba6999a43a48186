// SPDX-License-Identifier: MIT
#include "run/common/bars_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "input/case/support_places.hpp"
#include "lem/section/bars.hpp"
#include "mesh/planar.hpp"
#include "run/common/head.hpp"
#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/supports.hpp"

namespace talus::run {

namespace {

/// Slip at which bond and plate reach their strength [m]. Measured pull-out curves of nails and geogrids yield at one
/// to a few millimetres; the factor does not depend on it.
constexpr double yield_slip = 1e-3;
/// Stiffness of the joint between a pile and the soil over Young's modulus of the soil [1/m].
constexpr double joint_share = 100;
/// Strength of the anchorage of a bolt, and of a head that is stronger than its bar, over that of the bar.
constexpr double strong = 2;
/// Width of the facing that a head presses on, where no other head is nearer [m].
constexpr double widest_plate = 1;

/// Returns the ground within half a width of a head, as a polyline.
std::vector<Vec<2>> cut_ground(const site::Polyline& ground, const Vec<2>& head, double width) {
  double along = 0, place = 0, nearest = 1e300;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Vec<2>&a = ground[i - 1], &b = ground[i];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double t = std::clamp(
        ((head[0] - a[0]) * (b[0] - a[0]) + (head[1] - a[1]) * (b[1] - a[1])) / std::max(length * length, 1e-300), 0.0,
        1.0);
    const double distance = std::hypot(a[0] + t * (b[0] - a[0]) - head[0], a[1] + t * (b[1] - a[1]) - head[1]);
    if (distance < nearest) nearest = distance, place = along + t * length;
    along += length;
  }
  const double from = std::max(0.0, place - width / 2), to = std::min(along, place + width / 2);
  std::vector<Vec<2>> line;
  along = 0;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Vec<2>&a = ground[i - 1], &b = ground[i];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double first = std::max(from - along, 0.0), last = std::min(to - along, length);
    if (last > first) {
      const auto at = [&](double s) {
        return Vec<2>{a[0] + s / length * (b[0] - a[0]), a[1] + s / length * (b[1] - a[1])};
      };
      if (line.empty()) line.push_back(at(first));
      line.push_back(at(last));
    }
    along += length;
  }
  return line;
}

double find_plate_width(const std::vector<site::Bar>& bars, std::size_t i) {
  double width = widest_plate;
  for (std::size_t k = 0; k < bars.size(); ++k)
    if (k != i && bars[k].support == bars[i].support)
      width = std::min(width, std::hypot(bars[k].head[0] - bars[i].head[0], bars[k].head[1] - bars[i].head[1]));
  return width;
}

/// Returns Young's modulus of the stiffest soil of the case [Pa].
double find_stiffest(const site::Site& site) {
  double young = 0;
  for (const auto& [region, material] : site.data().regions)
    young = std::max(young, site.get_soil(region).young_modulus);
  return young;
}

/// Builds the bars of a case; the section of LEM, from which bond and soil pressure follow, only where it is needed.
class BarMaker {
 public:
  explicit BarMaker(const site::Site& site) : site_(site), bars_(site::list_bars(site)), walls_(list_walls(site)) {
    const bool needs = std::any_of(bars_.begin(), bars_.end(),
                                   [](const site::Bar& bar) { return bar.bond_factor > 0 || bar.has_soil_pressure; });
    if (needs) slope_ = std::make_shared<const lem::Slope>(make_section(site).section);
  }

  std::vector<fem::Bar> make() const {
    std::vector<fem::Bar> made;
    for (std::size_t i = 0; i < bars_.size(); ++i)
      if (bars_[i].kind != input::SupportKind::wall) made.push_back(make(i));
    return made;
  }

 private:
  fem::Bar make(std::size_t i) const {
    const site::Bar& bar = bars_[i];
    fem::Bar out;
    out.name = bar.support;
    out.head = bar.head;
    out.end = bar.end;
    out.axial_stiffness = bar.stiffness;
    out.reduces_bond = site_.data().supports.at(bar.support).sense == input::SupportSense::passive;
    if (bar.kind == input::SupportKind::pile) {
      make_pile(i, out);
      return out;
    }
    out.tensile = bar.tensile;
    out.prestress = std::min(bar.prestress, bar.tensile);
    out.free_length = bar.free_length;
    if (bar.bending > 0) {
      make_beam(bar, out);
      out.compressive = 0;
    }
    if (bar.kind == input::SupportKind::bolt) {
      out.free_length = bar.length();
      out.anchorage = strong * bar.tensile;
      out.anchorage_stiffness = bar.tensile / yield_slip;
    } else {
      set_bond(i, out);
    }
    if (bar.plate > 0) {
      out.plate = std::min(bar.plate, strong * bar.tensile);
      out.plate_stiffness = std::min(bar.plate, bar.tensile) / yield_slip;
      if (!is_buried(bar.head)) out.plate_line = cut_ground(site_.ground(), bar.head, find_plate_width(bars_, i));
      if (const auto wall = find_wall(site_, walls_, bar.head)) out.wall = static_cast<int>(*wall);
    }
    return out;
  }

  /// Returns true for a head on which a later stage of construction has placed soil.
  bool is_buried(const site::Point& head) const {
    const site::Polyline& ground = site_.ground();
    return mesh::compute_distance(head, ground) > input::near_ground * input::measure_width(ground);
  }

  void make_beam(const site::Bar& bar, fem::Bar& out) const {
    out.bending_stiffness = bar.bending;
    out.shear_stiffness = shear_share * bar.stiffness;
    if (bar.moment > 0) out.moment = bar.moment;
    out.lateral_stiffness = joint_share * find_stiffest(site_);
  }

  void make_pile(std::size_t i, fem::Bar& out) const {
    const site::Bar& bar = bars_[i];
    make_beam(bar, out);
    out.compressive = fem::unlimited;
    out.shear = bar.shear;
    out.bond_stiffness = out.lateral_stiffness;
    if (!bar.has_soil_pressure) return;
    const auto diagram =
        std::make_shared<const lem::BarDiagram>(lem::make_bar_diagram(*slope_, slope_->section().bars[i]));
    out.lateral = [diagram, head = bar.head, length = bar.length()](const Vec<2>& x) {
      const double s = std::hypot(x[0] - head[0], x[1] - head[1]), step = 1e-3 * length;
      const double from = std::max(0.0, s - step), to = std::min(length, s + step);
      return diagram->find_part(from, to) / (to - from);
    };
  }

  void set_bond(std::size_t i, fem::Bar& out) const {
    const site::Bar& bar = bars_[i];
    out.bond = [constant = bar.bond, factor = bar.bond_factor, slope = slope_](const Vec<2>& x) {
      return constant + (factor > 0 ? factor * std::max(0.0, slope->effective_stress({x[0], x[1]})) : 0);
    };
    double largest = 0;
    constexpr int places = 20;
    for (int k = 0; k <= places; ++k) {
      const double t = static_cast<double>(k) / places;
      largest = std::max(largest, out.bond({bar.head[0] + t * (bar.end[0] - bar.head[0]),
                                            bar.head[1] + t * (bar.end[1] - bar.head[1])}));
    }
    out.bond_stiffness = largest / yield_slip;
  }

  const site::Site& site_;
  std::vector<site::Bar> bars_;
  std::vector<WallLine> walls_;
  std::shared_ptr<const lem::Slope> slope_;
};

/// Integral of a curve, by its points, between two distances.
struct Used {
  double force = 0, limit = 0;
};
Used sum_bond(const fem::BarCurve& bond, double from, double to) {
  Used used;
  for (std::size_t i = 0; i < bond.place.size(); ++i) {
    if (bond.place[i] < from || bond.place[i] > to) continue;
    const double before = i == 0 ? bond.place[i] : bond.place[i - 1],
                 after = i + 1 == bond.place.size() ? bond.place[i] : bond.place[i + 1];
    used.force += 0.5 * (after - before) * bond.value[i];
    used.limit += 0.5 * (after - before) * bond.limit[i];
  }
  return used;
}

/// Returns the largest |value| over limit of a curve; nullopt without a limit.
std::optional<double> find_utilisation(const fem::BarCurve& curve) {
  std::optional<double> largest;
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    if (std::isfinite(curve.limit[i]))
      largest = std::max(largest.value_or(0), std::abs(curve.value[i]) / curve.limit[i]);
  return largest;
}

}  // namespace

std::vector<fem::Bar> make_bars(const site::Site& site) {
  return BarMaker(site).make();
}

std::string describe_bars(const input::Case& data) {
  std::string reduced;
  bool has_walls = false;
  for (const auto& [name, support] : data.supports) {
    has_walls = has_walls || support.kind == input::SupportKind::wall;
    if (support.sense == input::SupportSense::passive && support.kind != input::SupportKind::wall)
      reduced += (reduced.empty() ? "'" : ", '") + name + "'";
  }
  const char* walls = has_walls ? "; it divides the interfaces of walls as it divides the soil" : "";
  if (reduced.empty())
    return fmt::format("the factor divides the strength of the soil, not that of the supports or of their bond{}",
                       walls);
  return fmt::format(
      "the factor divides the strength of the soil, and the bond of supports with sense = \"passive\" ({}), not that "
      "of the supports themselves{}",
      reduced, walls);
}

results::ElementBar make_bar_result(const fem::BarForces& failed, const fem::BarForces& start) {
  results::ElementBar out;
  out.place = failed.axial.place;
  for (const double n : failed.axial.value) out.force.push_back(round_to(n, force_digits));
  for (const double n : start.axial.value) out.at_start.push_back(round_to(n, force_digits));
  std::size_t top = 0;
  for (std::size_t i = 0; i < failed.axial.value.size(); ++i)
    if (failed.axial.value[i] > failed.axial.value[top]) top = i;
  out.largest = out.force.empty() ? 0 : out.force[top];
  out.plate = round_to(failed.plate, force_digits);
  for (const double m : failed.moment.value) out.moment = std::max(out.moment, std::abs(m));
  out.moment = round_to(out.moment, force_digits);
  out.tension = find_utilisation(failed.axial);
  out.bending = find_utilisation(failed.moment);
  out.shear = find_utilisation(failed.shear);
  if (!failed.moment.value.empty()) {
    out.moments.emplace(), out.shears.emplace();
    for (const double m : failed.moment.value) out.moments->push_back(round_to(m, force_digits));
    for (const double v : failed.shear.value) out.shears->push_back(round_to(v, force_digits));
    out.moments_at_start.emplace(), out.shears_at_start.emplace();
    for (const double m : start.moment.value) out.moments_at_start->push_back(round_to(m, force_digits));
    for (const double v : start.shear.value) out.shears_at_start->push_back(round_to(v, force_digits));
  }
  if (out.largest > 0) {
    const double place = failed.axial.place[top];
    const Used behind = sum_bond(failed.bond, place, 1e300), front = sum_bond(failed.bond, 0, place);
    // The soil pulls the bar back into the slope behind the largest force, and out of it in front.
    if (std::isfinite(behind.limit) && behind.limit > 0) out.pull_out = behind.force / behind.limit;
    if (std::isfinite(front.limit) && front.limit + failed.plate_limit > 0)
      out.stripping = (failed.plate - front.force) / (front.limit + failed.plate_limit);
  }
  using Limit = results::ElementBarLimit;
  out.limit = select_limit<Limit>({{out.stripping, Limit::stripping},
                                   {out.pull_out, Limit::pull_out},
                                   {out.tension, Limit::tension},
                                   {out.shear, Limit::shear},
                                   {out.bending, Limit::bending}},
                                  Limit::none);
  return out;
}

std::vector<results::ElementBar> make_bar_results(const site::Site& site, const fem::SolidModel<2>& model,
                                                  const fem::ReductionResult<2>& found) {
  std::vector<site::Bar> bars = site::list_bars(site);
  std::erase_if(bars, [](const site::Bar& bar) { return bar.kind == input::SupportKind::wall; });
  const auto failed = fem::compute_bar_forces(model, found.at_failure, found.failed),
             start = fem::compute_bar_forces(model, found.at_full_strength, found.base_factor);
  std::vector<results::ElementBar> results;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    results::ElementBar& out = results.emplace_back(make_bar_result(failed[i], start[i]));
    out.support = bars[i].support;
    out.kind = input::get_word(bars[i].kind);
    out.row = bars[i].row;
    out.head = bars[i].head;
    out.end = bars[i].end;
    if (const int wall = model.bars[i].wall; wall >= 0) out.on_wall = model.walls[static_cast<std::size_t>(wall)].name;
  }
  const std::vector<WallLine> walls = list_walls(site);
  for (std::size_t w = 0; w < walls.size(); ++w)
    results.push_back(make_wall_result(walls[w], failed[bars.size() + w], start[bars.size() + w]));
  return results;
}

}  // namespace talus::run
