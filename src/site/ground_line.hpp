// SPDX-License-Identifier: MIT
#pragma once
// The ground of a plane section, the upper limit of all soil polygons, and its steep faces.

#include <array>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "input/case/case.hpp"
#include "mesh/ground.hpp"
#include "mesh/plan.hpp"

namespace talus::site {

class Site;

using Point = std::array<double, 2>;
using Polyline = std::vector<Point>;

using mesh::find_ground;

/// Returns the elevation of the ground at x [m]; at a step that of its upper end. Level beyond the ends.
double find_level(const Polyline& ground, double x);

/// Returns the lowest elevation of the soil [m].
double find_base(const mesh::Plan& plan);

/// Returns H, the difference between the highest and the lowest level of the ground [m]; the height of the soil if the
/// ground is level.
double find_slope_height(const mesh::Plan& plan, const Polyline& ground);

// Faces of cohesionless soil that are steeper than its friction angle, and therefore unstable.

struct SteepFace {
  Point lower{}, upper{};  ///< [m]
  std::string material;
  double slope = 0;           ///< β [rad]
  double friction_angle = 0;  ///< φ [rad]
  /// Returns tan φ / tan β, the factor of an infinite slope of dry soil.
  double factor() const;
};

/// Returns the faces of a plane section from left to right; none for a section with overhangs. Soil with suction or
/// roots is left out, as these stabilise it.
std::vector<SteepFace> find_steep_faces(const Site& site);

/// Returns the text of a warning: "The ground between (…) and (…) rises at 51.8°, …".
std::string describe(const SteepFace& face, const ShownUnit& length);

}  // namespace talus::site
