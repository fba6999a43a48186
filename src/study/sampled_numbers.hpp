#pragma once
// The uncertain numbers of a case: their keys, units and distributions, and how they are correlated.

#include <string>
#include <vector>

#include "input/read.hpp"
#include "study/distributions.hpp"

namespace talus::study {

struct SampledNumber {
  std::string key;   ///< dotted path
  std::string name;  ///< the shortest end of it that no other has
  std::string unit;  ///< of the key; empty: a plain number
  Marginal marginal;
  std::string text;  ///< "lognormal, mean 18 kPa, deviation 3.6 kPa"
};

struct SampledNumbers {
  std::vector<SampledNumber> numbers;
  std::vector<double> correlation;  ///< of the normal scores, row by row
  std::vector<std::string> notes;   ///< e.g. a distribution that was cut at the limit of its key

  std::vector<Marginal> list_marginals() const;
  std::vector<double> list_means() const;  ///< of the distributions as they are cut
};

/// [[study.random]] and [[study.correlation]] of a case that was read without a fault.
SampledNumbers read_sampled_numbers(const input::LoadedCase& base);

/// The changes that give the numbers these values.
std::vector<input::Override> set_values(const SampledNumbers& sampled, const std::vector<double>& values);

/// The case with these values of its numbers and without its [study]. Throws InputError where a value is impossible.
input::LoadedCase read_sample(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                              const SampledNumbers& sampled, const std::vector<double>& values);

}  // namespace talus::study
