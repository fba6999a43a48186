// SPDX-License-Identifier: MIT
#pragma once
// Circles that just touch a region: where a strong layer begins the factor jumps, and the smallest one stands right at
// the jump, in a valley too narrow for a lattice of trial circles.

#include <vector>

#include "lem/search/evaluator.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// For each region the best circle that touches it, among those with the ends of trial circles; regions that none
/// touches give none. `quick` ranks the circles (at most `most` for each region), `evaluate` solves the best of them.
std::vector<Surface> find_touching_circles(Evaluator& evaluate, Evaluator& quick, const Arcs& arcs,
                                           const TrialCircles& circles, int most);

}  // namespace talus::lem
