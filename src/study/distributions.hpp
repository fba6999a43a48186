// SPDX-License-Identifier: MIT
#pragma once
// Distributions of uncertain numbers (normal, lognormal, triangular and uniform, the first two optionally cut),
// counter-based random numbers, and samples of correlated scores.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "input/case/study.hpp"

namespace talus::study {

/// Φ(z), with full relative accuracy in the lower tail.
double find_normal_probability(double z);
/// Φ⁻¹(p) for 0 < p < 1; ∓infinity at 0 and 1.
double find_normal_score(double p);

/// Returns the interval of Clopper and Pearson (1934) for the probability of an event observed `count` times in
/// `samples`: it excludes the true probability with a probability of at most 1 - `confidence`, half on each side
/// (T20.4).
std::array<double, 2> bound_share(long count, long samples, double confidence);

/// Distribution of one number, in the unit of its key. `mean` and `deviation` of a normal or lognormal distribution
/// are those before it is cut.
struct Marginal {
  input::Distribution kind = input::Distribution::normal;
  double mean = 0, deviation = 0;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  double mode = 0;  ///< triangular

  /// Returns the quantile at the probability Φ(`score`).
  double find_value(double score) const;
  /// Probability of a value below `x`.
  double find_probability(double x) const;
  /// Mean and standard deviation of the cut distribution.
  double find_mean() const;
  double find_deviation() const;
  /// Probability of the uncut distribution below `lowest` or above `highest`.
  double find_cut_share() const;
};

/// Correlation of two numbers whose normal scores have the correlation `coefficient` (Nataf's integral, by
/// Gauss–Hermite quadrature).
double correlate_values(const Marginal& a, const Marginal& b, double coefficient);

/// Philox4x32-10 (Salmon, Moraes, Dror and Shaw 2011): returns four random words from a counter of four and a key of
/// two. Being functions of a counter, the numbers are the same on every machine and for any number of threads, and
/// independent between streams.
std::array<std::uint32_t, 4> scramble(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// Sequence of random numbers of one seed and one stream number.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  std::uint64_t draw_bits();
  /// Uniform in (0, 1), both ends excluded, in steps of 2⁻⁵².
  double draw_uniform();
  /// Uniform among 0 … count-1, without bias.
  std::uint64_t draw_below(std::uint64_t count);

 private:
  std::array<std::uint32_t, 2> key_;
  std::uint64_t stream_, drawn_ = 0;
  std::array<std::uint32_t, 4> words_{};
};

// Samples of correlated standard normal scores, by Latin hypercube or at random.

struct ScorePlan {
  int samples = 0, numbers = 0;
  std::uint64_t seed = 1;
  bool latin = true;                ///< Latin hypercube; otherwise independent samples
  int replicates = 1;               ///< number of independent Latin hypercubes among the samples
  std::vector<double> correlation;  ///< of the scores, numbers × numbers row by row, positive definite; empty: none
};

/// Returns scores [number][sample]. The samples of a Latin hypercube are consecutive: replicate r starts at
/// find_first(plan, r). In a hypercube of m samples every number has exactly one score in each of m equally probable
/// classes; the classes are paired such that the scores have the required correlation (Iman and Conover 1982).
std::vector<std::vector<double>> draw_scores(const ScorePlan& plan);

/// Index of the first sample of replicate `replicate`; for the number of replicates that of all samples.
int find_first(const ScorePlan& plan, int replicate);

}  // namespace talus::study
