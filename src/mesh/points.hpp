// SPDX-License-Identifier: MIT
#pragma once
// Where the material points of an element start.

#include <array>
#include <vector>

namespace talus::mesh {

/// The numbers of points per element that point_positions() knows: 1, 3, 6, 12 (D = 2) and 1, 4, 8, 10 (D = 3).
template <int D>
std::vector<int> allowed_points();

/// Local coordinates of the points that fill an element at the start; each point carries V_e / points_per_element.
/// The mean of every N_i over the points is exactly 1/(D+1), so gravity gives exact nodal forces; from 3 (2D) and
/// 4 (3D) points on, the means of N_i N_j are those of the element as well, so the consistent mass is exact too.
/// Throws Error (wrong_input) for any other number, naming the allowed ones.
template <int D>
std::vector<std::array<double, D>> point_positions(int points_per_element);

}  // namespace talus::mesh
