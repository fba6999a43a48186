// SPDX-License-Identifier: MIT
#pragma once
// Quadratic shape functions along a line with nodes at 0, ½ and 1, and Gauss's points on it: bars and walls.

#include <array>

namespace talus::fem {

/// Places on a line from 0 to 1, and weights.
inline constexpr std::array<std::array<double, 2>, 2> two_points{
    {{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}}};

/// Shape functions of the nodes.
inline std::array<double, 3> compute_shape(double t) {
  return {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
}
/// Their derivatives.
inline std::array<double, 3> compute_slope(double t) {
  return {4 * t - 3, 4 - 8 * t, 4 * t - 1};
}

}  // namespace talus::fem
