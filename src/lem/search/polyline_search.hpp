// SPDX-License-Identifier: MIT
#pragma once
// The search for the critical polyline of each method: from circles, from blocks along layers, and from one another.

#include <vector>

#include "lem/search/optimise.hpp"
#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// Masses that slide along a border of a region or along the base, between a steep upper and a flat lower end: for many
/// pairs of places along each border. Not evaluated. `seed`: see SearchOptions.
std::vector<Surface> make_blocks(const Slope& slope, int vertices, int seed);

/// The best polyline of each of options.methods; one without points where a method has none, or suits circles only.
/// `minima`: the optimised circles of each method.
std::vector<OptimisedSurface> find_polylines(const Slope& slope, const SearchOptions& options,
                                             const TrialCircles& circles, const SearchResult& result,
                                             const std::vector<std::vector<OptimisedSurface>>& minima);

}  // namespace talus::lem
