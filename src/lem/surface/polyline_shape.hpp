// SPDX-License-Identifier: MIT
#pragma once
// Shapes of admissible polyline surfaces.

#include <vector>

#include "lem/section/slope.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {

/// The surface from `left` to `right` on the ground that hangs below all points and all corners of the ground between
/// them, like a string pulled tight from below: the lower convex hull. A block that slides on it never has to bend
/// upwards, so every such surface is kinematically admissible, and it changes continuously with the points.
Surface hang_polyline(const Slope& slope, double left, double right, const std::vector<Point>& points);

/// `count` of the points of a hull, ends kept, that follow it best: the vertices whose loss changes it least go first.
std::vector<Point> thin_points(std::vector<Point> line, int count);

}  // namespace talus::lem
