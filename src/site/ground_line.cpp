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
