// SPDX-License-Identifier: MIT
// A section prepared for the cutting of many surfaces, the check of its regions, and the depth of its tension crack.
#include "lem/section/slope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "lem/section/bars.hpp"
#include "lem/section/piles.hpp"
#include "lem/section/strips.hpp"
#include "mesh/planar.hpp"

namespace talus::lem {

Slope::Slope(Section section) : strips_(std::make_unique<Strips>()) {
  const auto faults = find_faults(section);
  if (!faults.empty()) {
    std::string sentences;
    for (const std::string& fault : faults) sentences += (sentences.empty() ? "" : "\n") + fault;
    fail_input(sentences);
  }
  strips_->section = std::move(section);
  if (strips_->section.drawdown)
    strips_->before = std::make_unique<const Slope>(Section(*strips_->section.drawdown->before));
  build_strips(*strips_);
  for (const Bar& bar : strips_->section.bars) {
    strips_->bars.push_back(make_bar_diagram(*this, bar));
    strips_->embedded.push_back(bar.is_pile ? make_embedded_diagram(*this, bar) : BarDiagram{});
  }
  if (strips_->section.crack && strips_->section.crack->limited) strips_->crack_depths = compute_crack_depths(*this);
}

Slope::~Slope() = default;
Slope::Slope(Slope&&) noexcept = default;

const Section& Slope::section() const {
  return strips_->section;
}

const Slope* Slope::before() const {
  return strips_->before.get();
}

const Slope::Strips& Slope::strips() const {
  return *strips_;
}

double Slope::left() const {
  return strips_->strips.front().left;
}

double Slope::right() const {
  return strips_->strips.back().right;
}

double Slope::ground(double x) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  return strip.ground.at(x - strip.left);
}

double Slope::water_table(double x) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  return strip.water.at(x - strip.left);
}

double Slope::floor(double x) const {
  if (!strips_->firm && !strips_->raised) return section().base;
  const Strip& strip = strips_->strip(strips_->find(x));
  return strip.floor.at(x - strip.left);
}

double Slope::lower_floor(double x) const {
  const int i = strips_->find(x);
  const Strip& strip = strips_->strip(i);
  const double own = strip.floor.at(x - strip.left);
  if (i == 0 || x != strip.left) return own;
  const Strip& before = strips_->strip(i - 1);
  return std::min(own, before.floor.at(x - before.left));
}

double Slope::lower_ground(double x) const {
  const int i = strips_->find(x);
  const Strip& strip = strips_->strip(i);
  const double own = strip.ground.at(x - strip.left);
  if (i == 0 || x != strip.left) return own;
  const Strip& before = strips_->strip(i - 1);
  return std::min(own, before.ground.at(x - before.left));
}

int Slope::soil_at(const Point& p) const {
  const Strip& strip = strips_->strip(strips_->find(p[0]));
  const double dx = p[0] - strip.left;
  if (p[1] > strip.ground.at(dx) || p[1] < section().base) return -1;
  const int layer = strips_->find_layer(strip, dx, p[1]);
  return layer < 0 ? -1 : strips_->layer(layer).soil;
}

double Slope::pore_pressure(const Point& p) const {
  if (const auto u = strips_->pressure.find(p)) return *u;
  if (!section().piezometric_lines.empty()) {
    const Strip& strip = strips_->strip(strips_->find(p[0]));
    const int soil = soil_at(p);
    if (soil >= 0 && section().soils[static_cast<std::size_t>(soil)].piezometric_line >= 0)
      return section().water_unit_weight *
             (strip.find_water(section().soils[static_cast<std::size_t>(soil)]).at(p[0] - strip.left) - p[1]);
  }
  if (section().water_table.empty()) return 0;
  return section().water_unit_weight * (water_table(p[0]) - p[1]);
}

double Slope::pore_pressure(const Point& p, const Soil& soil, double weight) const {
  const double ratio = section().find_pressure_ratio(soil, p);
  return ratio > 0 ? ratio * weight : pore_pressure(p);
}

double Slope::crack_depth(double x) const {
  if (!section().crack) return 0;
  const std::vector<Point>& depths = strips_->crack_depths;
  if (depths.empty()) return section().crack->depth;
  const auto after =
      std::upper_bound(depths.begin(), depths.end(), x, [](double at, const Point& p) { return at < p[0]; });
  if (after == depths.begin() || after == depths.end()) return (after == depths.end() ? depths.back() : *after)[1];
  const Point &a = *std::prev(after), &b = *after;
  return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
}

double Slope::effective_stress(const Point& p) const {
  const Strip& strip = strips_->strip(strips_->find(p[0]));
  const double dx = p[0] - strip.left;
  int soil = -1;
  const double weight = std::max(0.0, weight_above(p[0], p[1], soil));
  if (soil < 0) return 0;
  if (const double ratio = section().find_pressure_ratio(section().soils[static_cast<std::size_t>(soil)], p); ratio > 0)
    return (1 - ratio) * weight;
  const double pond =
      strip.ponded ? section().water_unit_weight * std::max(0.0, strip.water.at(dx) - strip.ground.at(dx)) : 0;
  return std::max(0.0, weight + pond - std::max(0.0, pore_pressure(p)));
}

double Slope::weight_above(double x, double bottom, int& soil) const {
  const Strip& strip = strips_->strip(strips_->find(x));
  const double dx = x - strip.left;
  const int i = strips_->find_layer(strip, dx, bottom);
  if (i < 0) return 0;
  const Layer& layer = strips_->layer(i);
  soil = layer.soil;
  return layer.weight.at(dx) + layer.unit_weight * (layer.top.at(dx) - bottom);
}

// Check of the regions of a section whose ground has no faults.

namespace {

std::string name_region(const Section& section, std::size_t number) {
  const int soil = section.regions[number].soil;
  const bool known = soil >= 0 && soil < static_cast<int>(section.soils.size());
  const std::string& name = known ? section.soils[static_cast<std::size_t>(soil)].name : std::string();
  return name.empty() ? fmt::format("region {}", number + 1) : fmt::format("region {} of soil '{}'", number + 1, name);
}

/// Returns the polygon without repeated points.
std::vector<Point> drop_repeated(const std::vector<Point>& polygon) {
  std::vector<Point> kept;
  for (const Point& p : polygon)
    if (kept.empty() || p != kept.back()) kept.push_back(p);
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

bool check_polygon(const Section& section, std::size_t number, double size, std::vector<std::string>& faults) {
  const Region& region = section.regions[number];
  const std::string name = name_region(section, number);
  if (region.soil < 0 || region.soil >= static_cast<int>(section.soils.size())) {
    faults.push_back(fmt::format("{} names soil {}, which is not there", name, region.soil));
    return false;
  }
  const auto polygon = drop_repeated(region.polygon);
  if (!std::all_of(polygon.begin(), polygon.end(),
                   [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); })) {
    faults.push_back(fmt::format("{} has a point that is not a number", name));
    return false;
  }
  if (polygon.size() < 3) {
    faults.push_back(fmt::format("{} has fewer than three points", name));
    return false;
  }
  if (const auto place = mesh::find_self_contact(polygon, 1e-9 * size)) {
    faults.push_back(
        fmt::format("{} crosses or touches itself at {}", name, format_point(*place, section.units.length)));
    return false;
  }
  if (std::abs(mesh::compute_area(polygon)) < 1e-12 * size * size) {
    faults.push_back(fmt::format("{} has no area", name));
    return false;
  }
  double left = polygon[0][0], right = left, low = polygon[0][1];
  for (const Point& p : polygon) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
    low = std::min(low, p[1]);
  }
  const bool beside = right <= section.ground.front()[0] || left >= section.ground.back()[0];
  double top = section.ground[0][1];
  for (const Point& p : section.ground) top = std::max(top, p[1]);
  if (beside || low >= top) {
    faults.push_back(fmt::format("{} lies outside: it is {} the ground", name, beside ? "beside" : "above"));
    return false;
  }
  return true;
}

/// Range of x with the same fault, reported in one sentence.
struct Gap {
  const char* what;
  const ShownUnit& length;
  double from = 0, to = 0;
  bool open = false;
};

void extend_gap(Gap& gap, bool found, const Strip& strip, std::vector<std::string>& faults) {
  if (found && !gap.open) gap.from = strip.left;
  if (found) gap.to = strip.right;
  if (!found && gap.open)
    faults.push_back(fmt::format("no soil {} between x = {} and x = {}: no region covers it", gap.what,
                                 format_coordinate(gap.from / gap.length.si),
                                 format_coordinate(gap.to / gap.length.si)));
  gap.open = found;
}

/// Adds faults for places under the ground that no region covers. Below the lowest soil lies the bottom of the model,
/// which is no fault.
void check_cover(const Slope::Strips& strips, double size, std::vector<std::string>& faults) {
  const ShownUnit& length = strips.section.units.length;
  Gap bare{"under the ground", length}, hole{"in a hole of the regions", length};
  for (const Strip& strip : strips.strips) {
    const double half = 0.5 * (strip.right - strip.left);
    // There is nothing to cover where the ground meets the base.
    if (half < 1e-6 * size || strip.ground.at(half) - strips.section.base < 1e-6 * size) continue;
    bool is_bare = strip.first == strip.last, is_hole = false;
    for (int i = strip.first; i < strip.last; ++i) {
      const bool covered = strips.layer(i).soil >= 0;
      is_bare = is_bare || (i == strip.first && !covered);
      is_hole = is_hole || (i > strip.first + 1 && covered && strips.layer(i - 1).soil < 0);
    }
    extend_gap(bare, is_bare, strip, faults);
    extend_gap(hole, is_hole && !is_bare, strip, faults);
  }
  extend_gap(bare, false, {}, faults);
  extend_gap(hole, false, {}, faults);
}

}  // namespace

void find_region_faults(const Section& section, std::vector<std::string>& faults) {
  const double size = section.ground.back()[0] - section.ground.front()[0];
  bool sound = true;
  for (std::size_t i = 0; i < section.regions.size(); ++i) sound = check_polygon(section, i, size, faults) && sound;
  if (!sound) return;
  if (section.regions.empty()) {
    faults.push_back("the section has no region of soil");
    return;
  }
  Slope::Strips strips;
  strips.section = section;
  strips.section.pressure_grid.reset();
  build_strips(strips);
  check_cover(strips, size, faults);
}

namespace {

/// Number of depths that are tested before the limit is bisected.
constexpr int parts = 32;
constexpr int halvings = 40;
/// Places along the ground at which the depth is computed; it is linear between them.
constexpr int places_along = 200;

/// Stress that closes a crack at depth z under the ground, less the pressure of the water in it [Pa].
class Closure {
 public:
  Closure(const Slope& slope, double x, double water)
      : slope_(slope), strip_(slope.strips().strip(slope.strips().find(x))), x_(x), water_(water) {}

  double at(double z) const {
    const Section& section = slope_.section();
    const double dx = x_ - strip_.left, y = strip_.ground.at(dx) - z;
    const double inside = section.water_unit_weight * std::min(water_, z);
    int number = -1;
    const double soil_weight = slope_.weight_above(x_, y, number);
    if (number < 0) return -inside;
    const Soil& soil = section.soils[static_cast<std::size_t>(number)];
    const double standing = section.water_table.empty() ? 0 : std::max(0.0, strip_.water.at(dx) - strip_.ground.at(dx));
    const double vertical = soil_weight + strip_.load.at(dx) + section.water_unit_weight * standing;
    // The stress on the side of a crack vanishes, and the active plane is steep.
    constexpr double steep = std::numbers::pi / 3;
    const double held = soil.law ? std::max(0.0, vertical - strip_.variable_load.at(dx) -
                                                     std::max(0.0, slope_.pore_pressure({x_, y}, soil, soil_weight)))
                                 : 0;
    // The plane rises to either side, and the stronger one has the deeper crack.
    double stress = std::numeric_limits<double>::infinity();
    for (const double inclination : {steep, -steep}) {
      const StrengthTangent strength = find_strength(soil, {{x_, y}, z, held, inclination, steep, 0});
      double cohesion = strength.cohesion, u = 0;
      if (!soil.undrained) u = find_pressure(soil, soil_weight, {x_, y}, cohesion);
      const double angle = soil.law ? std::atan(strength.tan_friction) : soil.friction_angle;
      const double root = std::tan(std::numbers::pi / 4 - angle / 2);
      stress = std::min(stress, root * root * (vertical - u) - 2 * cohesion * root + u - inside);
      if (!soil.law || !soil.law->is_directed) break;
    }
    return stress;
  }

 private:
  /// Returns u as the slices use it; suction is added to the cohesion instead.
  double find_pressure(const Soil& soil, double weight, const Point& p, double& cohesion) const {
    const double found = slope_.pore_pressure(p, soil, weight);
    if (found >= 0 || soil.suction == Suction::ignored) return std::max(0.0, found);
    const double suction = std::min(-found, soil.largest_suction);
    cohesion += soil.suction == Suction::phi_b
                    ? suction * std::tan(soil.phi_b)
                    : suction * (soil.saturation ? soil.saturation(suction) : 1) * std::tan(soil.friction_angle);
    return 0;
  }

  const Slope& slope_;
  const Strip& strip_;
  double x_, water_;
};

double compute_crack_depth(const Slope& slope, double x) {
  const TensionCrack& crack = *slope.section().crack;
  const Closure closure(slope, x, crack.water);
  double open = 0, closed = crack.depth;
  for (int i = 1; i <= parts; ++i) {
    const double z = crack.depth * i / parts;
    if (closure.at(z) > 0) {
      closed = z;
      break;
    }
    open = z;
  }
  for (int i = 0; i < halvings && open < crack.depth; ++i) {
    const double z = 0.5 * (open + closed);
    (closure.at(z) > 0 ? closed : open) = z;
  }
  return open;
}

}  // namespace

std::vector<Point> compute_crack_depths(const Slope& slope) {
  std::vector<Point> depths;
  const double step = (slope.right() - slope.left()) / places_along;
  for (const Strip& strip : slope.strips().strips) {
    const double width = strip.right - strip.left, hair = 1e-9 * width;
    const int count = 1 + static_cast<int>(width / step);
    for (int i = 0; i <= count; ++i) {
      const double x = strip.left + std::clamp(width * i / count, hair, width - hair);
      depths.push_back({x, compute_crack_depth(slope, x)});
    }
  }
  return depths;
}

}  // namespace talus::lem
