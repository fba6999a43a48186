// SPDX-License-Identifier: MIT
#pragma once
// The results of slip surfaces and of the search for them.

#include <vector>

#include "lem/search/search.hpp"
#include "results/slices.hpp"

namespace talus::run {

/// The vertices of the bases, which a circle has too; of a surface that was refused its own.
std::vector<lem::Point> list_points(const lem::CutSurface& cut);

/// Method, factor and shape.
results::SlipSurface tell_surface(const lem::Critical& critical);
/// The same with checks, slices and warnings.
results::CriticalSurface tell_critical(const lem::Slope& slope, const lem::Critical& critical);

/// How many surfaces were tried and refused, why, where, and at which limits critical surfaces lie.
results::SliceSearch tell_search(const lem::SearchOptions& options, const lem::SearchResult& result);

/// Every circle with the factors by each method, and the least factor over each centre of a grid.
results::SliceTrials tell_trials(const lem::SearchOptions& options, const lem::SearchResult& result);

}  // namespace talus::run
