// SPDX-License-Identifier: MIT
#include "run/bounds/soil_kinks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "site/initial_water.hpp"

namespace talus::run {

namespace {

using mesh::Point2;
using mesh::Polyline;

/// Change of the gradient of a water table at a vertex, below which a vertical line does not repay its triangles.
constexpr double least_bend = 0.05;
/// Distance of neighbouring vertices of a water table over the element size, below which it is dense, and distance of a
/// vertex from the line between its neighbours, over the element size, up to which it is left out then.
constexpr double dense = 0.25, straight = 0.02;
/// Angle between the points of arcs.
constexpr double mesh_step = std::numbers::pi / 8, fine_step = std::numbers::pi / 180;

bool takes_water_table(const input::Case& data) {
  return data.initial.water.pressure == input::InitialPressure::water_table && !data.initial.water.water_table.empty();
}

/// Returns the points at one distance from a line, from left to right below it. Beyond its ends, and at a corner where
/// the soil has more than 180°, they lie on circles, of which there is a point after each angle of `step`.
Polyline move_down(Polyline line, double depth, double step) {
  if (line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
  Polyline below;
  const auto add = [&](const Point2& at, double angle) {
    below.push_back({at[0] + depth * std::cos(angle), at[1] + depth * std::sin(angle)});
  };
  double last = -std::numbers::pi;  // direction from the line, of what was added last
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 &a = line[i], &b = line[i + 1];
    const double normal = std::atan2(b[1] - a[1], b[0] - a[0]) - std::numbers::pi / 2, turn = normal - last;
    if (i > 0 && turn < 0) {  // both parallels meet
      const double half = 0.5 * turn;
      below.push_back({a[0] + depth / std::cos(half) * std::cos(last + half),
                       a[1] + depth / std::cos(half) * std::sin(last + half)});
    } else {
      const int parts = std::max(1, static_cast<int>(std::ceil(turn / step)));
      for (int k = 0; k <= parts; ++k) add(a, last + turn * k / parts);
    }
    last = normal;
  }
  const int parts = std::max(1, static_cast<int>(std::ceil(-last / step)));
  for (int k = 0; k <= parts; ++k) add(line.back(), last - last * k / parts);
  return below;
}

class SoilKinks {
 public:
  SoilKinks(const site::Site& site, const mesh::Plan& plan, const input::Material& soil, KinkDetail detail)
      : site_(site), data_(site.data()), plan_(plan), soil_(soil), is_every_(detail == KinkDetail::every) {}

  std::vector<Polyline> list() {
    if (soil_.traits().serves_slices && !soil_.known_strength) {
      const site::PlaneStrength strength = site::find_plane_strength(soil_);
      if (strength.cohesion_gradient != 0) add_level(strength.cohesion_level);
      if (material::needs<material::StrengthProfile>(soil_.model)) add_profile();
    }
    if (material::needs<material::ShansepInput>(soil_.model)) add_loads();
    if (material::needs<material::RootCohesionInput>(soil_.model)) add_roots();
    if (site::find_pressure_source(data_, soil_) == site::PressureSource::given &&
        !material::is_total_stress(soil_.model, soil_))
      add_water();
    return std::move(lines_);
  }

 private:
  void add_level(double y) { lines_.push_back({{plan_.box_min[0], y}, {plan_.box_max[0], y}}); }
  void add_vertical(double x) { lines_.push_back({{x, plan_.box_min[1]}, {x, plan_.box_max[1]}}); }

  void add_profile() {
    for (const double level : soil_.profile_levels) add_level(level);
    for (const double x : soil_.profile_x) add_vertical(x);
    if (!site_.has_ground()) return;
    for (const double depth : soil_.profile_depths) {
      Polyline below = site_.ground();
      for (Point2& x : below) x[1] -= depth;
      lines_.push_back(std::move(below));
    }
    if (is_every_ && !soil_.profile_depths.empty())
      for (const Point2& x : site_.ground()) add_vertical(x[0]);
  }

  /// Adds verticals below the ends and bends of surcharges, where the effective overburden jumps or bends.
  void add_loads() {
    for (const input::Surcharge& load : data_.surcharges)
      for (const double x : load.x) add_vertical(x);
  }

  /// Adds the lines at one distance from the line of the roots below which there are none, and those at which their
  /// share bends.
  void add_roots() {
    for (const input::Roots& roots : data_.roots) {
      std::vector<double> depths{roots.depth};
      if (is_every_ && roots.profile == input::RootProfile::table)
        for (const auto& [depth, share] : roots.depth_table)
          if (depth > 0 && depth < roots.depth) depths.push_back(depth);
      if (is_every_)
        for (const auto& [x, share] : roots.along) add_vertical(x);
      for (const Polyline& line : find_root_lines(roots.ground))
        for (const double depth : depths) lines_.push_back(move_down(line, depth, is_every_ ? fine_step : mesh_step));
    }
  }

  std::vector<Polyline> find_root_lines(const std::string& name) const {
    if (name == "top") return {{{plan_.box_min[0], plan_.box_max[1]}, plan_.box_max}};
    std::vector<Polyline> found;
    for (const mesh::Line& line : plan_.lines)
      if (line.name == name && line.points.size() > 1) found.push_back(line.points);
    return found;
  }

  void add_water() {
    if (takes_water_table(data_)) add_table();
  }

  /// Adds the water table of the soil, level beyond its ends, and verticals below its vertices; with every detail also
  /// the line above it from which suction does not grow any more.
  void add_table() {
    Polyline table = site::find_piezometric_line(data_, soil_);
    const double left = plan_.box_min[0], right = plan_.box_max[0];
    const auto is_dense = [&] {
      for (std::size_t i = 1; i < table.size(); ++i)
        if (table[i][0] - table[i - 1][0] < dense * plan_.size) return true;
      return false;
    };
    if (!is_every_ && is_dense()) table = mesh::drop_straight_points(table, false, straight * plan_.size);
    if (table.front()[0] > left) table.insert(table.begin(), {left, table.front()[1]});
    if (table.back()[0] < right) table.push_back({right, table.back()[1]});
    const auto find_gradient = [&](std::size_t i) {
      const double run = table[i + 1][0] - table[i][0];
      return run > 0 ? (table[i + 1][1] - table[i][1]) / run : 1e9;
    };
    std::vector<Polyline> verticals;
    for (std::size_t i = 1; i + 1 < table.size(); ++i) {
      const double top = is_every_ ? plan_.box_max[1] : table[i][1];
      if ((is_every_ || std::abs(find_gradient(i) - find_gradient(i - 1)) > least_bend) && top > plan_.box_min[1])
        verticals.push_back({{table[i][0], top}, {table[i][0], plan_.box_min[1]}});
    }
    const double highest = data_.initial.water.largest_suction / site_.water_weight();
    if (is_every_ && std::isfinite(highest)) {
      Polyline above = table;
      for (Point2& x : above) x[1] += highest;
      lines_.push_back(std::move(above));
    }
    lines_.push_back(std::move(table));
    lines_.insert(lines_.end(), verticals.begin(), verticals.end());
  }

  const site::Site& site_;
  const input::Case& data_;
  const mesh::Plan& plan_;
  const input::Material& soil_;
  bool is_every_;
  std::vector<Polyline> lines_;
};

}  // namespace

std::vector<mesh::Polyline> list_kinks(const site::Site& site, const mesh::Plan& plan, const input::Material& soil,
                                       KinkDetail detail) {
  return SoilKinks(site, plan, soil, detail).list();
}

}  // namespace talus::run
