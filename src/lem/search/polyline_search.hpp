// SPDX-License-Identifier: MIT
#pragma once
// Search for the critical polyline of each method, started from circles, from blocks along layers, and from the
// polylines of the other methods.

#include <vector>

#include "lem/search/optimise.hpp"
#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// Returns blocks that slide along a border of a region or along the base, between a steep upper and a flat lower end,
/// for many pairs of places along each border. The surfaces are not evaluated. `seed`: see SearchOptions.
std::vector<Surface> make_blocks(const Slope& slope, int vertices, int seed);

/// Returns the best polyline of each of options.methods; one without points where a method has no solution or applies
/// to circles only. `minima`: the optimised circles of each method.
std::vector<OptimisedSurface> find_polylines(const Slope& slope, const SearchOptions& options,
                                             const TrialCircles& circles, const SearchResult& result,
                                             const std::vector<std::vector<OptimisedSurface>>& minima);

}  // namespace talus::lem
