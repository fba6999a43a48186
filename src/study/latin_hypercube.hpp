// SPDX-License-Identifier: MIT
#pragma once
// Samples of correlated standard normal scores, by Latin hypercube or at random.

#include <cstdint>
#include <vector>

namespace talus::study {

struct ScorePlan {
  int samples = 0, numbers = 0;
  std::uint64_t seed = 1;
  bool latin = true;                ///< Latin hypercube; else independent samples
  int replicates = 1;               ///< Latin hypercubes, each drawn for itself, that make up the samples
  std::vector<double> correlation;  ///< of the scores, numbers × numbers row by row, positive definite; empty: none
};

/// Scores [number][sample]. The samples of a Latin hypercube stand one after the other: replicate r holds those from
/// find_first(plan, r). Of a hypercube of m samples every number has exactly one score in each of m equally probable
/// classes; the classes are paired so that the numbers' scores have the wanted correlation (Iman and Conover 1982).
std::vector<std::vector<double>> draw_scores(const ScorePlan& plan);

/// The first sample of replicate `replicate`; all samples for the number of replicates.
int find_first(const ScorePlan& plan, int replicate);

}  // namespace talus::study
