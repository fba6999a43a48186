// SPDX-License-Identifier: MIT
#pragma once
// Local minima of a search, lost circles, and the warnings on a search: rejected surfaces and limits that were reached.

#include <string>
#include <vector>

#include "lem/search/arcs.hpp"
#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

// Local minima among the trial circles, and the overlap of two sliding masses.

/// Returns the elevation of a slip surface at x between its ends [m].
double find_elevation(const Slope& slope, const Surface& surface, double x);
/// Returns x of the left and the right end of a surface [m].
std::array<double, 2> find_ends(const Surface& surface);
/// Returns true if the left end is the lower one, so that the mass slides to the left. The searches count from the
/// lower end, so that a mirrored slope is searched in the same steps.
bool falls_left(const Slope& slope, const Surface& surface);

/// Returns the area common to two sliding masses over the area of their union, 0 to 1.
double measure_overlap(const Slope& slope, const Surface& a, const Surface& b);

/// Returns the circles with a smaller factor than all their neighbours in the lattice, best first; a factor of 0 means
/// rejected. Of two masses that overlap by more than `most_overlap` the one with the smaller factor stays; at most
/// `count`.
std::vector<int> find_local_minima(const Slope& slope, const TrialCircles& circles, const std::vector<float>& factors,
                                   int count, double most_overlap);

// Lost circles: those on which a method of complete equilibrium has no solution, although Bishop's factor there is
// below any factor of that method. The cause is tension at the crest of steep cohesive slopes.

/// Searches, for each method with lost circles, circles that end in a dry tension crack: the shallowest crack, up to
/// Rankine's tension zone, with which the method comes within 2 % of Bishop's factor. If its factor is smaller, the
/// circle replaces the critical one of the method. Nothing is done where the section has a crack of its own, or where
/// the bottom of the crack would be below the water.
void search_cracked_circles(const Slope& slope, const SearchOptions& options, const Arcs& arcs,
                            const TrialCircles& circles, SearchResult& result);

/// Adds a warning if Bishop's critical circle still has a lower factor than all methods of complete equilibrium, and
/// these have no solution on it.
void warn_of_lost_circles(const Slope& slope, const SearchOptions& options, SearchResult& result);

/// Returns the reasons of rejection of one method: "12,000 of 18,375 … go below the base, …".
std::string describe_refusals(const std::map<Refusal, long>& refused, long tried);

/// Returns the limits that the critical circle of a method reaches: ends of the searched ranges, edge of the model,
/// base, smallest depth; for a grid search also the border of the grid and of the radii, by the best trial circle.
std::vector<LimitHit> find_limit_hits(const Slope& slope, const SearchOptions& options, const SearchResult& result,
                                      const TrialCircles& circles, const Critical& critical, int best_trial);

/// Returns the warnings on one critical surface: m_α, tension, line of thrust, edge of the model.
std::vector<std::string> find_warnings(const Slope& slope, const Checks& checks, const Critical& critical);

/// Returns the smallest factor per centre: of the grid's centres, or of the circles binned by their centres.
SearchResult::Map map_centres(const SearchResult& result, std::size_t method, int columns, int rows);

}  // namespace talus::lem
