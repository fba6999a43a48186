// SPDX-License-Identifier: MIT
#pragma once
// The slices over a base, and what presses on vertical steps of the ground.

#include <vector>

#include "lem/slices/solve.hpp"
#include "lem/slices/strips.hpp"
#include "lem/surface/mass.hpp"

namespace talus::lem {

/// About `count` slices over the stretches of a base, with area and depth of the mass; forces and inclinations as if it
/// slid to the left.
void fill_slices(const Slope::Strips& strips, const BaseLine& base, int count, CutSurface& cut);

/// The end of the mass that is the side of a crack.
enum class CrackEnd { none, left, right };

/// Adds ponded water and loads on the ground's vertical steps, inside and at the ends of the mass; none in the crack.
void press_on_faces(const Slope::Strips& strips, std::vector<Slice>& slices, CrackEnd crack);

// Pore pressure and strength at the base of a slice.

/// Sets u, c and tanφ of a slice whose geometry stands; `weight` of the soil above its base [N/m²]. `before`: the same
/// slice before drawdown; nullptr without one.
void add_strength(const Slope::Strips& strips, const Strip& strip, double weight, const Slice* before, Slice& slice);

/// Cohesion of roots at a place [Pa].
double find_root_cohesion(const Section& section, const Point& p);

}  // namespace talus::lem
