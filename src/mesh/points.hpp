// SPDX-License-Identifier: MIT
#pragma once
// Initial positions of the material points in an element.

#include <array>
#include <vector>

namespace talus::mesh {

/// Returns the numbers of points per element that point_positions() accepts: 1, 3, 6, 12 (D = 2) and 1, 4, 8, 10 (D =
/// 3).
template <int D>
std::vector<int> allowed_points();

/// Returns the initial local coordinates of the points of an element, each of volume V_e / points_per_element. The mean
/// of every N_i over the points is exactly 1/(D+1), so gravity gives exact nodal forces; from 3 (2D) and 4 (3D) points
/// on, the means of N_i N_j are also those of the element, so the consistent mass is exact too. Throws Error
/// (wrong_input) with the allowed numbers for any other number.
template <int D>
std::vector<std::array<double, D>> point_positions(int points_per_element);

}  // namespace talus::mesh
