#pragma once
// Results of limit equilibrium as JSON. SI units, angles in radians, forces per metre of thickness.

#include <nlohmann/json.hpp>

#include "lem/search/search.hpp"

namespace talus::run {

/// The surface as points from left to right; arcs are cut into chords.
std::vector<lem::Point> list_points(const lem::CutSurface& cut);

/// One surface by one method with its slices.
nlohmann::json to_json(const lem::Slope& slope, const lem::Critical& critical);
/// The same without slices, for lists of local minima.
nlohmann::json to_short_json(const lem::Critical& critical);

/// What was searched and what was found out on the way.
nlohmann::json describe_search(const lem::SearchOptions& options, const lem::SearchResult& result);

/// Every trial circle and the maps of smallest factors.
nlohmann::json describe_trials(const lem::SearchOptions& options, const lem::SearchResult& result);

}  // namespace talus::run
