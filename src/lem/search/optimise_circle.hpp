// SPDX-License-Identifier: MIT
#pragma once
// Local optimisation of a circle: its two ends on the ground and its depth.

#include "lem/search/evaluator.hpp"
#include "lem/surface/arcs.hpp"

namespace talus::lem {

/// Where the ends of a circle may go, and how far the first steps reach [m].
struct CircleRanges {
  std::array<double, 2> left{}, right{};
  std::array<double, 2> step{};
};

/// Never worse than `start`. Besides free ends and depth it tries ends held in corners of the ground, and depths at
/// which the circle just touches a region: the factor has a crease there that a minimiser does not follow.
OptimisedSurface optimise_circle(Evaluator& evaluate, const Arcs& arcs, const Surface& start,
                                 const CircleRanges& ranges);

}  // namespace talus::lem
