// SPDX-License-Identifier: MIT
#pragma once
// Factors of one case that lie so far apart that one of them is no result of this slope.

#include <optional>
#include <string>

#include "results/about.hpp"

namespace talus::results {

struct RunResult;

/// Ratio of two factors above which neither may be used: flow rules, meshes and assumptions of the methods make less.
/// It is a little below 3, so that a factor of a third is named whichever end of an interval it is compared with.
inline constexpr double largest_ratio = 2.5;

/// The two factors of the same state that lie farthest apart.
struct Disagreement {
  std::string low_title, high_title;  ///< "FEM (ψ as given)"
  double low = 0, high = 0;           ///< factors or proven bounds [-]
  double ratio = 1;                   ///< high over low, above largest_ratio
  std::string text;                   ///< the statement, one sentence
};
void describe(Visitor& v, Disagreement& r);

/// Returns the pair of factors of `run` with the largest ratio, if that is above `largest_ratio`. LEM enters with its
/// governing surface; its methods are compared among themselves by the results of their searches and on each given
/// surface. Bounds enter where they are proven for the soil of the case. Factors that limit analysis rules out, and
/// surfaces that a search would reject, do not enter. Factors of a timeline and of stages are compared at equal times.
std::optional<Disagreement> find_disagreement(const RunResult& run);

}  // namespace talus::results
