// SPDX-License-Identifier: MIT
#pragma once
// Pore pressure and strength at the base of a slice.

#include "lem/slices/solve.hpp"
#include "lem/slices/strips.hpp"

namespace talus::lem {

/// Sets u, c and tanφ of a slice whose geometry stands; `weight` of the soil above its base [N/m²]. `before`: the same
/// slice before drawdown; nullptr without one.
void add_strength(const Slope::Strips& strips, const Strip& strip, double weight, const Slice* before, Slice& slice);

/// Cohesion of roots at a place [Pa].
double find_root_cohesion(const Section& section, const Point& p);

}  // namespace talus::lem
