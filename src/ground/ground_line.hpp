// SPDX-License-Identifier: MIT
#pragma once
// The ground of a plane section: the upper limit of all soil polygons, from left to right.

#include <array>
#include <vector>

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

}  // namespace talus::ground
