// SPDX-License-Identifier: MIT
#pragma once
// Circles on which a method with complete equilibrium has no solution, although Bishop's method has a smaller factor
// there than that method finds anywhere: the crest of steep cohesive slopes is in tension.

#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"
#include "lem/surface/arcs.hpp"

namespace talus::lem {

/// Searches, for each method that lost circles, circles that end in a dry tension crack: the least deep one, up to
/// Rankine's tension zone, with which the method comes within 2 % of Bishop's factor. A smaller factor than the
/// method's own replaces its critical circle. Skipped where the section has a crack of its own, and
/// below the water at the crest.
void search_cracked_circles(const Slope& slope, const SearchOptions& options, const Arcs& arcs,
                            const TrialCircles& circles, SearchResult& result);

/// Adds a warning where Bishop's critical circle still is lower than all that methods of complete equilibrium found,
/// and they have no solution on it.
void warn_of_lost_circles(const Slope& slope, const SearchOptions& options, SearchResult& result);

}  // namespace talus::lem
