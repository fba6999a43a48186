// SPDX-License-Identifier: MIT
#pragma once
// Sentences about a search: why surfaces were refused, and limits that were hit.

#include <string>
#include <vector>

#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// "12,000 of 18,375 … go below the base, …" for the reasons of one method.
std::string describe_refusals(const std::map<Refusal, long>& refused, long tried);

/// Limits that the critical circle of a method reaches: ends of searched ranges, the model's edge, the
/// base, the smallest depth; on a grid search also the border of the grid and of the radii, by the best trial circle.
std::vector<LimitHit> find_limit_hits(const Slope& slope, const SearchOptions& options, const SearchResult& result,
                                      const TrialCircles& circles, const Critical& critical, int best_trial);

/// Warnings on one critical surface: m_α, tension, line of thrust, edge of the model.
std::vector<std::string> find_warnings(const Slope& slope, const Checks& checks, const Critical& critical);

/// The smallest factor per centre: of the grid's centres, or of the circles binned by their centres.
SearchResult::Map map_centres(const SearchResult& result, std::size_t method, int columns, int rows);

}  // namespace talus::lem
