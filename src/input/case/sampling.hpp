#pragma once
// Uncertain numbers of a case, for `talus study` with mode = "sample".

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace talus::input {

enum class Distribution { normal, lognormal, triangular, uniform };
enum class SampledMethod { lem, fem, mpm };
enum class SamplePlan { latin_hypercube, random };

/// An uncertain number: values are TOML texts with units, as for --set.
struct RandomNumber {
  std::string key;  ///< dotted path of the key
  Distribution distribution = Distribution::normal;
  std::string mean, deviation;        ///< normal, lognormal: texts of values; mean empty: the case's own value
  std::optional<double> variation;    ///< coefficient of variation instead of the deviation [-]
  std::string lowest, mode, highest;  ///< triangular, uniform: limits; normal, lognormal: cut there
};

struct Correlation {
  std::vector<std::string> keys;  ///< two
  double coefficient = 0;         ///< of the normal scores [-]
};

struct Sampling {
  int samples = 10000;
  std::uint64_t seed = 1;
  SamplePlan plan = SamplePlan::latin_hypercube;
  SampledMethod method = SampledMethod::lem;
  std::vector<RandomNumber> numbers;
  std::vector<Correlation> correlations;
  std::vector<double> runout;  ///< mpm: distances whose exceedance is told [m]; empty: chosen
  double confidence = 0.95;    ///< of the interval [-]
};

}  // namespace talus::input
