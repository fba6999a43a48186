// SPDX-License-Identifier: MIT
#pragma once
// Distributions of uncertain numbers: normal, lognormal, triangular and uniform, the first two cut where asked.

#include <limits>
#include <string>

#include "input/case/sampling.hpp"

namespace talus::study {

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

}  // namespace talus::study
