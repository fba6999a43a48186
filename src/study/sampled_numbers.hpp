// SPDX-License-Identifier: MIT
#pragma once
// The uncertain numbers of a case: their keys, units and distributions, and how they are correlated.

#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/sampling.hpp"
#include "study/distributions.hpp"

namespace talus::study {

// Short names of keys.

/// The shortest end of `path` that no other of `all` ends with.
std::string shorten_path(const std::string& path, const std::vector<std::string>& all);

struct SampledNumbers {
  std::vector<results::UncertainNumber> numbers;  ///< their names are the shortest ends of keys that no other has
  std::vector<Marginal> marginals;                ///< of each
  std::vector<double> means;                      ///< of the distributions as they are cut
  std::vector<double> correlation;                ///< of the normal scores, row by row; empty: none
  std::vector<std::string> notes;                 ///< e.g. a distribution that was cut at the limit of its key
};

/// [[study.random]] and [[study.correlation]] of a case that was read without a fault.
SampledNumbers read_sampled_numbers(const input::LoadedCase& base);

/// The changes that make the case with these values of its numbers, without its [study].
std::vector<input::Override> set_values(const std::vector<input::Override>& overrides, const SampledNumbers& sampled,
                                        const std::vector<double>& values);

/// That case. Throws InputError where a value is impossible.
input::LoadedCase read_sample(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                              const SampledNumbers& sampled, const std::vector<double>& values);

}  // namespace talus::study
