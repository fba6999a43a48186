// SPDX-License-Identifier: MIT
#pragma once
// The slices over a base, and what presses on vertical steps of the ground.

#include <vector>

#include "lem/surface/base_line.hpp"

namespace talus::lem {

/// About `count` slices over the stretches of a base, with area and depth of the mass; forces and inclinations as if it
/// slid to the left.
void fill_slices(const Slope::Strips& strips, const BaseLine& base, int count, CutSurface& cut);

/// The end of the mass that is the side of a crack.
enum class CrackEnd { none, left, right };

/// Adds ponded water and loads on the ground's vertical steps, inside and at the ends of the mass; none in the crack.
void press_on_faces(const Slope::Strips& strips, std::vector<Slice>& slices, CrackEnd crack);

}  // namespace talus::lem
