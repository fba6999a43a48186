// SPDX-License-Identifier: MIT
// The ground line as the upper limit of the polygons, and steep faces of cohesionless soil.
#include "site/ground_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/planar.hpp"
#include "site/site.hpp"

namespace talus::site {

namespace {

/// Lengths below this fraction of the section's width count as zero.
constexpr double nothing = 1e-9;

struct Edge {
  Point a{}, b{};  ///< a[0] < b[0]
  int polygon = 0;
  double at(double x) const { return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]); }
  bool spans(double x) const { return a[0] < x && x < b[0]; }
};

std::vector<Edge> list_edges(const mesh::Plan& plan, double least) {
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < plan.polygons.size(); ++p) {
    const auto& corners = plan.polygons[p].points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Point a = corners[i], b = corners[(i + 1) % corners.size()];
      if (std::abs(a[0] - b[0]) <= least) continue;  // a vertical edge bounds no soil above or below
      if (a[0] > b[0]) std::swap(a, b);
      edges.push_back({a, b, static_cast<int>(p)});
    }
  }
  return edges;
}

/// Returns all x at which the order of the edges may change.
std::vector<double> list_breaks(const std::vector<Edge>& edges, double least) {
  std::vector<double> breaks;
  for (const Edge& e : edges) {
    breaks.push_back(e.a[0]);
    breaks.push_back(e.b[0]);
    for (const Edge& f : edges) {
      const double from = std::max(e.a[0], f.a[0]), to = std::min(e.b[0], f.b[0]);
      if (to - from <= least) continue;
      const double before = e.at(from) - f.at(from), after = e.at(to) - f.at(to);
      if (before * after < 0) breaks.push_back(from + (to - from) * before / (before - after));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> distinct;
  for (const double x : breaks)
    if (distinct.empty() || x - distinct.back() > least) distinct.push_back(x);
  return distinct;
}

/// Throws Error (wrong_input) if the soil at `x` has a gap below its upper limit. `levels`: elevations of the edges at
/// x, with their polygons.
void check_column(std::vector<std::pair<double, int>> levels, double x, double least, const ShownUnit& length) {
  std::sort(levels.begin(), levels.end());
  std::vector<std::array<double, 2>> filled;
  std::vector<std::pair<int, double>> open;  // polygon, elevation of its lower limit
  for (const auto& [y, polygon] : levels) {
    const auto begun =
        std::find_if(open.begin(), open.end(), [polygon = polygon](const auto& o) { return o.first == polygon; });
    if (begun == open.end()) {
      open.emplace_back(polygon, y);
    } else {
      filled.push_back({begun->second, y});
      open.erase(begun);
    }
  }
  std::sort(filled.begin(), filled.end());
  double top = filled.empty() ? 0 : filled.front()[1];
  for (const auto& [from, to] : filled) {
    if (from - top > least)
      throw Error(ExitCode::wrong_input, fmt::format("the soil at x = {} has a gap between y = {} and {}: LEM, "
                                                     "and water and loads on the ground, need soil without overhangs "
                                                     "and cavities from the ground down",
                                                     format_coordinate(x, length), format_coordinate(top, length),
                                                     format_coordinate(from, length)));
    top = std::max(top, to);
  }
}

}  // namespace

Polyline find_ground(const mesh::Plan& plan) {
  double left = std::numeric_limits<double>::max(), right = std::numeric_limits<double>::lowest();
  for (const mesh::Polygon& p : plan.polygons)
    for (const Point& x : p.points) left = std::min(left, x[0]), right = std::max(right, x[0]);
  const double least = nothing * (right - left);
  const std::vector<Edge> edges = list_edges(plan, least);
  const std::vector<double> breaks = list_breaks(edges, least);
  const ShownUnit& length = plan.units.length;
  Polyline ground;
  const auto add = [&](const Point& x) {
    if (!ground.empty() && std::hypot(x[0] - ground.back()[0], x[1] - ground.back()[1]) <= 2 * least) return;
    ground.push_back(x);
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    const Edge* top = nullptr;
    std::vector<std::pair<double, int>> levels;
    for (const Edge& e : edges) {
      if (!e.spans(middle)) continue;
      levels.emplace_back(e.at(middle), e.polygon);
      if (top == nullptr || e.at(middle) > top->at(middle)) top = &e;
    }
    if (top == nullptr)
      throw Error(ExitCode::wrong_input,
                  fmt::format("there is no soil between x = {} and {}: LEM, and water and loads "
                              "on it, need a ground without gaps",
                              format_coordinate(breaks[i], length), format_coordinate(breaks[i + 1], length)));
    check_column(std::move(levels), middle, least, length);
    add({breaks[i], top->at(breaks[i])});
    add({breaks[i + 1], top->at(breaks[i + 1])});
  }
  return mesh::drop_straight_points(ground, false, least);
}

double find_level(const Polyline& ground, double x) {
  if (x < ground.front()[0]) return ground.front()[1];
  if (x > ground.back()[0]) return ground.back()[1];
  double level = std::numeric_limits<double>::lowest();
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    if (x < a[0] || x > b[0]) continue;
    level = std::max(level, b[0] > a[0] ? a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) : std::max(a[1], b[1]));
  }
  return level;
}

double find_base(const mesh::Plan& plan) {
  double base = std::numeric_limits<double>::max();
  for (const mesh::Polygon& p : plan.polygons)
    for (const Point& x : p.points) base = std::min(base, x[1]);
  return base;
}

double find_slope_height(const mesh::Plan& plan, const Polyline& ground) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Point& x : ground) low = std::min(low, x[1]), high = std::max(high, x[1]);
  return high > low ? high - low : high - find_base(plan);
}

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Tolerance for rounded coordinates of a slope at the angle of repose [rad].
constexpr double rounding = 0.1 * degree;

/// Returns the material of the smallest polygon at a point; nullptr if there is none.
const std::string* find_material(const input::Case& data, const Point& below) {
  const std::string* found = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::Polygon& polygon : data.mesh.polygons) {
    const auto region = data.regions.find(polygon.name);
    if (region == data.regions.end() || !mesh::is_inside(below, polygon.points)) continue;
    const double area = std::abs(mesh::compute_area(polygon.points));
    if (area >= least) continue;
    least = area;
    found = &region->second;
  }
  return found;
}

/// Returns φ of a soil without cohesion and suction; nothing for other soils.
std::optional<double> find_bare_friction(const input::Material& m) {
  const auto strength = material::find_slice_strength(m.model, m);
  if (!strength || strength->law || strength->cohesion > 0 || strength->cohesion_gradient > 0) return std::nullopt;
  const bool has_suction = m.slices.suction_strength == input::SuctionStrength::phi_b ||
                           (m.slices.suction_strength != input::SuctionStrength::none && m.water.is_wet());
  return has_suction ? std::nullopt : std::optional(strength->friction_angle);
}

}  // namespace

double SteepFace::factor() const {
  return std::tan(friction_angle) / std::tan(slope);
}

std::vector<SteepFace> find_steep_faces(const Site& site) {
  std::vector<SteepFace> faces;
  const input::Case& data = site.data();
  if (!site.has_ground() || !data.roots.empty()) return faces;
  const Polyline& ground = site.ground();
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    if (!(length > 0) || dy == 0) continue;
    // A point just behind the face.
    const double depth = 1e-4 * length;
    const Point below{(a[0] + b[0]) / 2 + depth * dy / length, (a[1] + b[1]) / 2 - depth * dx / length};
    const std::string* material = find_material(data, below);
    if (material == nullptr) continue;
    const std::optional<double> friction = find_bare_friction(data.materials.at(*material));
    const double slope = std::atan2(std::abs(dy), dx);
    if (!friction || slope <= *friction + rounding) continue;
    faces.push_back({dy > 0 ? a : b, dy > 0 ? b : a, *material, slope, *friction});
  }
  return faces;
}

std::string describe(const SteepFace& face, const ShownUnit& length) {
  return fmt::format(
      "The ground between {} and {} rises at {:.1f}°, more than φ = {:.1f}° of '{}', which "
      "has no cohesion: it is unstable by inspection (a long slope of it has the factor {:.2f}), whatever a method "
      "finds. Check the cohesion and the geometry.",
      format_point(face.lower, length), format_point(face.upper, length), face.slope / degree,
      face.friction_angle / degree, face.material, face.factor());
}

}  // namespace talus::site
