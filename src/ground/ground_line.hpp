// SPDX-License-Identifier: MIT
#pragma once
// The ground of a plane section: the upper limit of all soil polygons, from left to right.

#include <array>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/plan.hpp"

namespace talus::ground {

using Point = std::array<double, 2>;
using Polyline = std::vector<Point>;

/// A vertical step has two points with the same x. Throws Error (wrong_input) when the soil has a gap, overhangs or
/// holds a cavity, with the place: methods of slices need soil from the ground down.
Polyline find_ground(const mesh::Plan& plan);

/// Elevation of the ground at x [m]; of a step its upper end. Level beyond the ends.
double find_level(const Polyline& ground, double x);

/// Lowest elevation of the soil [m].
double find_base(const mesh::Plan& plan);

/// Difference between the highest and the lowest level of the ground [m]: H. The height of the soil itself where the
/// ground is level.
double find_slope_height(const mesh::Plan& plan, const Polyline& ground);

// Faces of soil without cohesion that are steeper than its friction angle: unstable by inspection.

struct SteepFace {
  Point lower{}, upper{};  ///< [m]
  std::string material;
  double slope = 0;           ///< β [rad]
  double friction_angle = 0;  ///< φ [rad]
  /// tan φ / tan β, the factor of a long slope of dry soil.
  double factor() const;
};

/// From left to right; of a plane section without overhangs. Soil with suction or roots is left out: they hold it.
std::vector<SteepFace> find_steep_faces(const input::Case& data);

/// "The ground between (…) and (…) rises at 51.8°, …".
std::string describe(const SteepFace& face);

// Water tables that are drawn as no water can stand.

/// Sentences on the water tables of a plane case, before and after a drawdown: free water that slopes, ends inside the
/// section that flood lower ground, water far above the crest, and lines that lie outside the section.
std::vector<std::string> find_odd_water(const input::Case& data);

/// The same of one line; `name` begins the sentences: "The water table".
std::vector<std::string> find_odd_water(const Polyline& table, const Polyline& ground, double base,
                                        const std::string& name);

}  // namespace talus::ground
