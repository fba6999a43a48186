// SPDX-License-Identifier: MIT
#include "mesh/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/check_plan.hpp"

namespace talus::mesh {
namespace {

/// Soil on more than a half circle by less is a bend of the ground, not a corner.
constexpr double least_turn = 10 * std::numbers::pi / 180;
/// Looks around a corner: one every degree.
constexpr int looks = 360;

bool has_soil(const Plan& plan, const Point2& x) {
  return std::any_of(plan.polygons.begin(), plan.polygons.end(),
                     [&](const Polygon& polygon) { return is_inside(x, polygon.points); });
}

bool is_on_box(const Plan& plan, const Point2& x, double near) {
  for (int d = 0; d < 2; ++d)
    if (x[d] - plan.box_min[d] < near || plan.box_max[d] - x[d] < near) return true;
  return false;
}

/// Angle of the soil around `x`, which lies inside the box, at a distance of `radius`.
double measure_soil_angle(const Plan& plan, const Point2& x, double radius) {
  int soil = 0;
  for (int i = 0; i < looks; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / looks;
    soil += has_soil(plan, {x[0] + radius * std::cos(angle), x[1] + radius * std::sin(angle)});
  }
  return 2 * std::numbers::pi * soil / looks;
}

}  // namespace

std::vector<Point2> find_reentrant_corners(const Plan& plan) {
  const double near = get_tolerance(plan), radius = 100 * near;
  std::vector<Point2> corners;
  for (const Polygon& polygon : plan.polygons)
    for (const Point2& x : polygon.points) {
      const bool known = std::any_of(corners.begin(), corners.end(),
                                     [&](const Point2& c) { return std::hypot(c[0] - x[0], c[1] - x[1]) <= near; });
      if (known || is_on_box(plan, x, radius)) continue;
      const double angle = measure_soil_angle(plan, x, radius);
      if (angle >= std::numbers::pi + least_turn && angle < 2 * std::numbers::pi - least_turn) corners.push_back(x);
    }
  return corners;
}

Plan refine_corners(Plan plan, double finer, double reach) {
  if (!(finer > 1)) return plan;
  for (const Point2& corner : find_reentrant_corners(plan))
    plan.refinements.push_back({{corner}, plan.size / finer, reach * plan.size});
  return plan;
}

}  // namespace talus::mesh
