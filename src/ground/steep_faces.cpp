// SPDX-License-Identifier: MIT
#include "ground/steep_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/planar.hpp"

namespace talus::ground {
namespace {

constexpr double degree = std::numbers::pi / 180;
/// Rounded coordinates of a slope at the angle of repose are not steeper [rad].
constexpr double rounding = 0.1 * degree;

/// The material below a place of the ground: of the smallest polygon there; nullptr where there is none.
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

/// φ of a soil that nothing but friction holds; nothing: it has cohesion, suction or no strength of that kind.
std::optional<double> find_bare_friction(const input::Material& m) {
  const auto strength = material::find_slice_strength(m.model, m);
  if (!strength || strength->cohesion > 0 || strength->cohesion_gradient > 0) return std::nullopt;
  const bool has_suction = m.slices.suction_strength == input::SuctionStrength::phi_b ||
                           (m.slices.suction_strength != input::SuctionStrength::none && m.water.is_wet());
  return has_suction ? std::nullopt : std::optional(strength->friction_angle);
}

}  // namespace

double SteepFace::factor() const {
  return std::tan(friction_angle) / std::tan(slope);
}

std::vector<SteepFace> find_steep_faces(const input::Case& data) {
  std::vector<SteepFace> faces;
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty() || !data.roots.empty()) return faces;
  Polyline ground;
  try {
    ground = find_ground(data.mesh);
  } catch (const Error&) {
    return faces;  // finite elements and material points take sections with overhangs
  }
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    if (!(length > 0) || dy == 0) continue;
    // Just behind the face.
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

std::string describe(const SteepFace& face) {
  return fmt::format(
      "The ground between {} and {} rises at {:.1f}°, more than φ = {:.1f}° of '{}', which "
      "has no cohesion: it is unstable by inspection (a long slope of it has the factor {:.2f}), whatever a method "
      "finds. Check the cohesion and the geometry.",
      format_point(face.lower), format_point(face.upper), face.slope / degree, face.friction_angle / degree,
      face.material, face.factor());
}

}  // namespace talus::ground
