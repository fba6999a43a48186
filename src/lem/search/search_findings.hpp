// SPDX-License-Identifier: MIT
#pragma once
// Sentences about a search: why surfaces were refused, and limits that were hit.

#include <string>
#include <vector>

#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"
#include "lem/surface/arcs.hpp"

namespace talus::lem {

// Separate local minima among trial surfaces, and how much two sliding masses have in common.

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

// Circles on which a method with complete equilibrium has no solution, although Bishop's method has a smaller factor
// there than that method finds anywhere: the crest of steep cohesive slopes is in tension.

/// Searches, for each method that lost circles, circles that end in a dry tension crack: the least deep one, up to
/// Rankine's tension zone, with which the method comes within 2 % of Bishop's factor. A smaller factor than the
/// method's own replaces its critical circle. Skipped where the section has a crack of its own, and
/// below the water at the crest.
void search_cracked_circles(const Slope& slope, const SearchOptions& options, const Arcs& arcs,
                            const TrialCircles& circles, SearchResult& result);

/// Adds a warning where Bishop's critical circle still is lower than all that methods of complete equilibrium found,
/// and they have no solution on it.
void warn_of_lost_circles(const Slope& slope, const SearchOptions& options, SearchResult& result);

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
