// SPDX-License-Identifier: MIT
#pragma once
// The uncertain numbers of a case: keys, units, distributions and correlations.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/sampling.hpp"
#include "study/distributions.hpp"

namespace talus::study {

/// Returns the shortest end of `path` that is not an end of another path in `all`.
std::string shorten_path(const std::string& path, const std::vector<std::string>& all);

struct SampledNumbers {
  std::vector<results::UncertainNumber> numbers;  ///< their names are the shortest unique ends of their keys
  std::vector<Marginal> marginals;                ///< one for each number
  std::vector<double> means;                      ///< of the cut distributions
  std::vector<double> correlation;                ///< of the normal scores, row by row; empty: none
  std::vector<std::string> notes;                 ///< e.g. a distribution that was cut at the limit of its key
};

/// Reads [[study.random]] and [[study.correlation]] of a valid case.
SampledNumbers read_sampled_numbers(const input::LoadedCase& base);

/// Returns the overrides that set these values of the numbers, without the [study] of the case.
std::vector<input::Override> set_values(const std::vector<input::Override>& overrides, const SampledNumbers& sampled,
                                        const std::vector<double>& values);

/// Reads the case with these values. Throws InputError if a value is impossible.
input::LoadedCase read_sample(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                              const SampledNumbers& sampled, const std::vector<double>& values);

// Reliability index without sampling: from the derivatives at the means, and from the design point.

/// Factor of safety for values of all numbers, in the units of their keys; nullopt if there is none.
using FactorOf = std::function<std::optional<double>(const std::vector<double>&)>;

/// β = ln(F/√(1+V²))/√ln(1+V²), V = σ_F/F, of a lognormal factor (Hassan and Wolff 1999).
double find_lognormal_index(double mean, double deviation);

/// Estimates the index by first-order second-moment at the means, with F linear in the numbers, as
/// `summary.first_order`; and F at one deviation below and above the mean of each number, the others at their means,
/// as `summary.tornado`, longest bar first. Sets neither if a factor is missing.
void estimate_first_order(const SampledNumbers& sampled, const FactorOf& factor, results::Sampling& summary);

/// Computes the index of Hasofer and Lind (1974): the distance of the failure surface F = 1 from the origin of
/// independent normal scores, by the iteration of Rackwitz and Fiessler (1978) with a line search; negative if the
/// slope fails at the medians. Importance is the square of the direction to the design point; with correlations, of
/// the scores in their order. Returns nullopt if a factor is missing.
std::optional<results::DesignPointEstimate> find_design_point(const SampledNumbers& sampled, const FactorOf& factor);

}  // namespace talus::study
