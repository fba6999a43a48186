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
results::SlipSurface make_surface_result(const lem::Critical& critical);
/// The same with checks, slices and warnings.
results::CriticalSurface make_critical_result(const lem::Slope& slope, const lem::Critical& critical);

/// How many surfaces were tried and refused, why, where, and at which limits critical surfaces lie.
results::SliceSearch make_search_result(const lem::SearchOptions& options, const lem::SearchResult& result);

/// Every circle with the factors by each method, and the least factor over each centre of a grid.
results::SliceTrials make_trials_result(const lem::SearchOptions& options, const lem::SearchResult& result);

}  // namespace talus::run
