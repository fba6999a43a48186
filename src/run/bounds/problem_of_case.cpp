// SPDX-License-Identifier: MIT
#include "run/bounds/problem_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "run/bounds/bars_of_case.hpp"
#include "run/bounds/case_fields.hpp"
#include "run/bounds/kink_lines.hpp"
#include "run/bounds/problem_walls.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/ground_load.hpp"
#include "site/mesh_sides.hpp"

namespace talus::run {

namespace {

/// Least component of a unit normal that counts as parallel to an axis.
constexpr double along_axis = 1 - 1e-9;
/// A side with a smaller run, over its length and over the width of the section, counts as vertical.
constexpr double vertical = 1e-9;
/// Distance of the lines of the first mesh along bedding, over its element size.
constexpr double bedding_spacing = 0.5;

class ProblemBuilder {
 public:
  ProblemBuilder(const site::Site& site, Supports supports)
      : site_(site),
        data_(site_.data()),
        supports_(supports),
        bars_(std::make_shared<const BarsOfCase>(site)),
        mesh_(make_mesh()) {}

  ProblemOfCase build() {
    made_.notes = site_.list_open_ends();
    made_.notes.insert(made_.notes.end(), mesh_notes_.begin(), mesh_notes_.end());
    fields_ = std::make_shared<CaseFields>(site_, mesh_, made_.water);
    add_triangles();
    add_strengths();
    add_walls(site_, mesh_, number_, made_.problem);
    add_sides();
    bars_->add(mesh_, number_, made_.problem);
    enclose_case();
    return std::move(made_);
  }

 private:
  mesh::Mesh<2> make_mesh() {
    const mesh::Plan plan = bars_->conform(conform_to_loaded_walls(
        site_, site::conform_to_loads(site_, mesh::resize(data_.mesh, input::find_bounds_size(data_)))));
    if (has_bedding(data_)) return generate_with_bedding(data_, plan, bedding_spacing, mesh_notes_);
    return generate_with_kinks(site_, plan);
  }

  /// Adds the triangles with soil, with nodes numbered anew.
  void add_triangles() {
    const site::HeldWater<2>& water = fields_->water();
    const Vec<2> direction = site_.find_body_force<2>();
    number_.assign(mesh_.nodes.size(), -1);
    bounds::Problem& p = made_.problem;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (mesh_.element_region[e] == mesh::empty_region) continue;
      bounds::Triangle triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto node = static_cast<std::size_t>(mesh_.elements[e][i]);
        if (number_[node] < 0) {
          number_[node] = static_cast<int>(p.nodes.size());
          p.nodes.push_back(mesh_.nodes[node]);
        }
        triangle[i] = number_[node];
      }
      p.triangles.push_back(triangle);
      p.region.push_back(mesh_.element_region[e]);
      p.body_force.push_back({direction[0] * water.unit_weight[e], direction[1] * water.unit_weight[e]});
      p.pore_pressure.push_back({-water.pore[e][0], -water.pore[e][1], -water.pore[e][2]});
    }
  }

  void add_strengths() {
    bounds::Problem& p = made_.problem;
    fields_->enclose_envelopes(bounds::find_units(p).stress);
    p.strength = fields_->find_strengths(bounds::Bound::lower);
    if (fields_->has_envelopes()) outer_ = fields_->find_strengths(bounds::Bound::upper);
  }

  /// Makes two problems where strengths and pressures are on one side of the case only.
  void enclose_case() {
    made_.fields = fields_;
    const auto enclosure = std::make_shared<const CaseEnclosure>(fields_, made_.problem);
    const bool has_bent_bars = bars_->are_bent(made_.problem);
    if (!outer_.empty() || enclosure->is_needed() || has_bent_bars) made_.stronger = made_.problem;
    if (!outer_.empty()) made_.stronger->strength = outer_;
    if (enclosure->is_needed()) {
      enclosure->apply(made_.problem, bounds::Bound::lower);
      enclosure->apply(*made_.stronger, bounds::Bound::upper);
      made_.enclosure = enclosure;
      if (const std::string gap = enclosure->describe_gap(); !gap.empty()) made_.notes.push_back(gap);
    }
    if (has_bent_bars) {
      bars_->enclose(made_.problem, bounds::Bound::lower);
      bars_->enclose(*made_.stronger, bounds::Bound::upper);
      made_.bars = bars_;
    }
  }

  bounds::EdgeKey find_key(const std::array<int, 2>& side) const {
    return bounds::make_key(number_[static_cast<std::size_t>(side[0])], number_[static_cast<std::size_t>(side[1])]);
  }

  void add_sides() {
    bounds::Problem& p = made_.problem;
    std::map<bounds::EdgeKey, bounds::Side> border;
    for (const bounds::Edge& edge : bounds::list_edges(p.triangles))
      if (edge.other < 0) border[bounds::make_key(edge.from, edge.to)] = {edge.from, edge.to, false, false, {}};
    if (supports_ == Supports::below_soil)
      for (auto& [key, side] : border) side.holds_normal = side.holds_along = !is_ground(side);
    for (const input::Boundary& b : data_.boundaries) {
      if (supports_ == Supports::below_soil) break;
      for (const auto& named : site::find_sides(mesh_, b.on))
        if (const auto side = border.find(find_key(named)); side != border.end()) hold(b, side->second);
    }
    note_free_base(border);
    std::map<bounds::EdgeKey, bounds::Side> named = border;  // tractions on named sides
    for (const auto& load : site::make_surface_loads<2>(site_, mesh_)) {
      const bool is_named = std::any_of(data_.tractions.begin(), data_.tractions.end(),
                                        [&](const input::Traction& t) { return t.on == load.name; });
      add_load(load, is_named ? named : border);
    }
    check_loads(border);
    refuse_held_walls(border);
    for (auto& [key, side] : border)
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t d = 0; d < 2; ++d) side.traction[k][d] += named.at(key).traction[k][d];
    for (const auto& [key, side] : border) p.sides.push_back(side);
  }

  /// Without a fixed side that faces downwards no stress field carries the weight, and none is in equilibrium.
  void note_free_base(const std::map<bounds::EdgeKey, bounds::Side>& border) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const auto& [key, side] : border) {
      const auto &from = made_.problem.nodes[static_cast<std::size_t>(side.from)],
                 &to = made_.problem.nodes[static_cast<std::size_t>(side.to)];
      if (side.holds_normal && to[0] - from[0] > vertical * std::hypot(to[0] - from[0], to[1] - from[1])) return;
      lowest = std::min({lowest, from[1], to[1]});
    }
    made_.notes.push_back(
        fmt::format("no [[boundary]] fixes the base of the soil: 'bottom' is the lowest level of the section, {}; give "
                    "an inclined base as a [[geometry.line]] and fix that",
                    format_value(lowest, data_.units().length)));
  }

  /// A wall on a fixed side would be held by it, and its beam not.
  void refuse_held_walls(const std::map<bounds::EdgeKey, bounds::Side>& border) const {
    for (const bounds::Wall& wall : made_.problem.walls)
      for (std::size_t i = 0; i < wall.size(); ++i) {
        const auto side = border.find(bounds::make_key(wall.nodes[i], wall.nodes[i + 1]));
        if (side == border.end() || (!side->second.holds_normal && !side->second.holds_along)) continue;
        throw Error(ExitCode::wrong_input,
                    fmt::format("a wall lies on a fixed side of the section at {}: limit analysis takes walls in the "
                                "soil or on its surface",
                                format_point(made_.problem.nodes[static_cast<std::size_t>(wall.nodes[i])],
                                             data_.units().length)));
      }
  }

  void add_load(const fem::SurfaceLoad<2>& load, std::map<bounds::EdgeKey, bounds::Side>& border) const {
    for (std::size_t i = 0; i < load.sides.size(); ++i) {
      const auto side = border.find(find_key(load.sides[i]));
      if (side == border.end())
        throw Error(ExitCode::wrong_input,
                    fmt::format("the traction on '{}' is not on the surface of the soil: limit analysis takes loads "
                                "there only",
                                load.name));
      for (std::size_t k = 0; k < 2; ++k) {
        const int node = number_[static_cast<std::size_t>(load.sides[i][k])];
        auto& own = side->second.traction[node == side->second.from ? 0 : 1];
        for (std::size_t d = 0; d < 2; ++d) own[d] += load.traction[i][k][d];
      }
    }
  }

  /// Checks the loads against the case, because the certificates are those of the given problem.
  void check_loads(const std::map<bounds::EdgeKey, bounds::Side>& border) const {
    if (!site::needs_ground(site_)) return;
    std::vector<LoadedSide> sides;
    for (const auto& [key, side] : border)
      if (is_ground(side))
        sides.push_back({made_.problem.nodes[static_cast<std::size_t>(side.from)],
                         made_.problem.nodes[static_cast<std::size_t>(side.to)], side.traction});
    if (const auto wrong = find_wrong_load(site_, sides))
      throw Error(ExitCode::wrong_input, "limit analysis: " + *wrong);
  }

  /// Returns true for sides that face upwards, and for vertical ones between the ends of the ground.
  bool is_ground(const bounds::Side& side) const {
    const auto &from = made_.problem.nodes[static_cast<std::size_t>(side.from)],
               &to = made_.problem.nodes[static_cast<std::size_t>(side.to)];
    const double run = from[0] - to[0], length = std::hypot(run, to[1] - from[1]);
    if (std::abs(run) > vertical * length) return run > 0;
    const site::Polyline& ground = site_.ground();
    const double least = vertical * (ground.back()[0] - ground.front()[0]);
    return from[0] > ground.front()[0] + least && from[0] < ground.back()[0] - least;
  }

  void hold(const input::Boundary& b, bounds::Side& side) const {
    const auto &from = made_.problem.nodes[static_cast<std::size_t>(side.from)],
               &to = made_.problem.nodes[static_cast<std::size_t>(side.to)];
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
    if (b.fix == input::Fix::full) side.holds_normal = side.holds_along = true;
    if (b.fix == input::Fix::normal) side.holds_normal = true;
    if (b.fix != input::Fix::plane) return;
    const double across = std::abs(b.normal[0] * dy - b.normal[1] * dx) / length,
                 along = std::abs(b.normal[0] * dx + b.normal[1] * dy) / length;
    if (across < along_axis && along < along_axis)
      throw Error(
          ExitCode::wrong_input,
          fmt::format("limit analysis can fix '{}' across or along itself only, not along ({:g}, {:g}); use fix "
                      "= \"normal\"",
                      b.on, b.normal[0], b.normal[1]));
    (across > along ? side.holds_normal : side.holds_along) = true;
  }

  const site::Site site_;
  const input::Case& data_;
  Supports supports_;
  std::shared_ptr<const BarsOfCase> bars_;
  std::vector<std::string> mesh_notes_;
  const mesh::Mesh<2> mesh_;
  std::shared_ptr<CaseFields> fields_;
  std::vector<std::array<bounds::Strength, 3>> outer_;  ///< of the triangles, with tangents; empty without polygons
  std::vector<int> number_;                             ///< of the nodes of the mesh; -1: not in soil
  ProblemOfCase made_;
};

}  // namespace

/// A first mesh with more triangles than allowed for the last one is usually a typing error, and would use all memory.
void check_bounds(const input::Case& data) {
  constexpr double slack = 4;  // a mesh may have four times as many triangles as the one before
  if (!data.bounds.size || !data.mesh.file.empty()) return;
  const double size = *data.bounds.size, count = count_elements(mesh::resize(data.mesh, size)).soil,
               most = slack * data.bounds.triangles;
  if (!(count > most)) return;
  const ShownUnit& length = data.units().length;
  const double fits = size / length.si * std::sqrt(count / most), unit = std::pow(10, std::floor(std::log10(fits)) - 1);
  throw Error(ExitCode::wrong_input,
              fmt::format("'size' in [bounds] is {}, with which the first mesh has about {:.2g} triangles, and "
                          "'triangles' allows {} in the last one; {} would do",
                          format_value(size, length), count, data.bounds.triangles,
                          format_value(std::ceil(fits / unit) * unit * length.si, length)));
}

bounds::BoundsResult find_case_bounds(const ProblemOfCase& made, const bounds::BoundsOptions& options,
                                      const bounds::BoundsReport& report) {
  bounds::SafeProblems problems{made.problem, made.stronger, {}};
  if (made.enclosure || made.bars)
    problems.evaluate = [&](bounds::Problem& p, bounds::Bound bound) {
      if (made.enclosure) made.enclosure->apply(p, bound);
      if (made.bars) made.bars->enclose(p, bound);
    };
  bounds::BoundsResult found = bounds::find_bounds(problems, options, report);
  hold_to_case(*made.fields, found);
  return found;
}

ProblemOfCase make_bounds_problem(const site::Site& site, Supports supports) {
  if (supports == Supports::as_given) check_bounds(site.data());
  return ProblemBuilder(site, supports).build();
}

namespace {

/// Differences up to this fraction of the largest load, or of the pressure of water as deep as the ground is wide, are
/// rounding errors. The second one applies to a water table along the ground, whose load consists of rounding errors.
constexpr double rounding_of_loads = 1e-6, rounding_of_water = 1e-12;
/// Number of points at which a side is checked.
constexpr int side_samples = 9;

/// Interpolates a polyline at x, level beyond its ends; `ys` has the length of `xs`.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto after = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin());
  if (after == 0) return ys.front();
  if (after == xs.size()) return ys.back();
  const double part = (x - xs[after - 1]) / (xs[after] - xs[after - 1]);
  return ys[after - 1] + part * (ys[after] - ys[after - 1]);
}

class GivenLoads {
 public:
  explicit GivenLoads(const site::Site& site)
      : data_(site.data()), ponds_(site.ponds()), weight_(data_.water.density * data_.gravity.acceleration) {
    for (const auto& x : site.water_table()) table_x_.push_back(x[0]), table_y_.push_back(x[1]);
  }

  /// Traction on ground with this upward normal [Pa].
  Vec<2> find(const Vec<2>& x, const Vec<2>& normal) const {
    double surcharge = 0;
    for (const input::Surcharge& s : data_.surcharges)
      if (x[0] > s.x.front() && x[0] < s.x.back()) surcharge += interpolate(s.x, s.load, x[0]);
    double depth = 0;
    for (const site::Pond& p : ponds_)
      if (x[0] > p.from[0] && x[0] < p.to[0])
        depth = std::max(depth, interpolate({p.from[0], p.to[0]}, {p.level_from, p.level_to}, x[0]) - x[1]);
    if (!table_x_.empty()) depth = std::max(depth, interpolate(table_x_, table_y_, x[0]) - x[1]);
    double pressure = weight_ * depth;
    for (const input::Slurry& s : data_.slurries)
      if (x[0] > s.x[0] && x[0] < s.x[1]) pressure += s.unit_weight * std::max(0.0, s.level - x[1]);
    return {-pressure * normal[0], -pressure * normal[1] - surcharge * normal[1]};
  }

 private:
  const input::Case& data_;
  const std::vector<site::Pond>& ponds_;
  double weight_;
  std::vector<double> table_x_, table_y_;
};

}  // namespace

std::optional<std::string> find_wrong_load(const site::Site& site, const std::vector<LoadedSide>& sides) {
  const input::Case& data = site.data();
  const GivenLoads given(site);
  double largest = 0, most = 0, left = std::numeric_limits<double>::infinity(), right = -left;
  Vec<2> where{};
  for (const LoadedSide& side : sides) {
    const double run = side.from[0] - side.to[0], rise = side.to[1] - side.from[1], length = std::hypot(run, rise);
    const Vec<2> normal{rise / length, run / length};
    left = std::min({left, side.from[0], side.to[0]}), right = std::max({right, side.from[0], side.to[0]});
    if (normal[1] < 1e-6) continue;  // the water beside a vertical step counts for it
    for (int i = 1; i <= side_samples; ++i) {
      const double s = static_cast<double>(i) / (side_samples + 1);
      const Vec<2> x{side.from[0] - s * run, side.from[1] + s * rise};
      const Vec<2> of_case = given.find(x, normal);
      double off = 0;
      for (std::size_t d = 0; d < 2; ++d)
        off = std::hypot(off, (1 - s) * side.traction[0][d] + s * side.traction[1][d] - of_case[d]);
      largest = std::max(largest, norm(of_case));
      if (off > most) most = off, where = x;
    }
  }
  const double water = data.water.density * data.gravity.acceleration * (right - left);
  if (!(most > rounding_of_loads * largest + rounding_of_water * water)) return std::nullopt;
  return fmt::format("at {} the load on the ground differs from that of the case by {}: nothing is proven",
                     format_point(where, data.units().length), format_value(most, data.units().stress, 3));
}

}  // namespace talus::run
