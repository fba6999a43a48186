// SPDX-License-Identifier: MIT
#pragma once
// How deep a tension crack can be.

#include <vector>

#include "lem/section/slope.hpp"

namespace talus::lem {

/// x and depth of the crack of a section along the ground [m], no deeper than given and than where Rankine's active
/// stress of the soil beside it equals the pressure of the water in it,
/// σ_h = K_a (σ_v - u) - 2c √K_a + u = γ_w min(water, z), with K_a = tan²(45° - φ/2) (Terzaghi 1943).
std::vector<Point> compute_crack_depths(const Slope& slope);

}  // namespace talus::lem
