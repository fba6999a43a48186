// SPDX-License-Identifier: MIT
#pragma once
// Distributions of uncertain numbers: normal, lognormal, triangular and uniform, the first two cut where asked.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "input/case/study.hpp"

namespace talus::study {

// The standard normal distribution, and the exact interval of a counted share.

/// Φ(z), with full relative accuracy in the lower tail.
double find_normal_probability(double z);
/// Φ⁻¹(p) for 0 < p < 1; ∓infinity at 0 and 1.
double find_normal_score(double p);

/// Clopper and Pearson's (1934) interval for a probability of which `count` out of `samples` were seen: the true one
/// lies outside it with at most 1 - `confidence`, half on each side.
std::array<double, 2> bound_share(long count, long samples, double confidence);

/// The distribution of one number, in the unit of its key. `mean` and `deviation` of a normal or lognormal one are
/// those before it is cut.
struct Marginal {
  input::Distribution kind = input::Distribution::normal;
  double mean = 0, deviation = 0;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  double mode = 0;  ///< triangular

  /// The value whose share below it is Φ(`score`).
  double find_value(double score) const;
  /// Probability of a value below `x`.
  double find_probability(double x) const;
  /// Of the distribution as it is cut.
  double find_mean() const;
  double find_deviation() const;
  /// Probability that the uncut distribution lies beyond `lowest` or `highest`.
  double find_cut_share() const;
};

/// The correlation of two numbers whose normal scores have the correlation `coefficient` (Nataf's integral, by
/// Gauss–Hermite quadrature).
double correlate_values(const Marginal& a, const Marginal& b, double coefficient);

// Random numbers from a counter: the same on every machine, for any number of threads, and independent between streams.

/// Philox4x32-10 (Salmon, Moraes, Dror and Shaw 2011): four random words of a counter of four and a key of two.
std::array<std::uint32_t, 4> scramble(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// The random numbers of one seed and one stream number, in their order.
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
