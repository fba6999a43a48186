// SPDX-License-Identifier: MIT
#pragma once
// Separate local minima among trial surfaces, and how much two sliding masses have in common.

#include <vector>

#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// Elevation of a slip surface at x between its ends [m].
double find_elevation(const Slope& slope, const Surface& surface, double x);
/// Left and right end of a surface [m].
std::array<double, 2> find_ends(const Surface& surface);
/// True for a mass that slides to the left: its left end is the lower one. The searches count from the lower end, so
/// that a mirrored slope is searched in the same steps.
bool falls_left(const Slope& slope, const Surface& surface);

/// Area common to two sliding masses over the area of both together, 0 to 1.
double measure_overlap(const Slope& slope, const Surface& a, const Surface& b);

/// Circles that have a smaller factor than all their neighbours in the lattice, best first; factors of 0 are refused
/// ones. Of two whose masses overlap by more than `most_overlap` the better one stays; at most `count`.
std::vector<int> find_local_minima(const Slope& slope, const TrialCircles& circles, const std::vector<float>& factors,
                                   int count, double most_overlap);

}  // namespace talus::lem
