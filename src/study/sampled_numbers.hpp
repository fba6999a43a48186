// SPDX-License-Identifier: MIT
#pragma once
// The uncertain numbers of a case: keys, units, distributions and correlations.

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

}  // namespace talus::study
