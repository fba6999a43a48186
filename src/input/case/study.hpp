// SPDX-License-Identifier: MIT
#pragma once
// [study]: keys that are varied, and the sampling of uncertain numbers.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

// [[study.random]] and [[study.correlation]]: uncertain numbers for `talus study` with mode = "sample".

enum class Distribution { normal, lognormal, triangular, uniform };
enum class SampledMethod { lem, fem, mpm };
enum class SamplePlan { latin_hypercube, random };

/// An uncertain number; values are TOML texts with units, as for --set.
struct RandomNumber {
  std::string key;  ///< dotted path of the key
  Distribution distribution = Distribution::normal;
  std::string mean, deviation;        ///< normal, lognormal: texts of values; empty mean: the value of the case
  std::optional<double> variation;    ///< coefficient of variation instead of the deviation [-]
  std::string lowest, mode, highest;  ///< triangular, uniform: limits; normal, lognormal: truncation
};

struct Correlation {
  std::vector<std::string> keys;  ///< exactly two
  double coefficient = 0;         ///< correlation of the standard normal variables [-]
};

struct Sampling {
  int samples = 10000;
  std::uint64_t seed = 1;
  SamplePlan plan = SamplePlan::latin_hypercube;
  SampledMethod method = SampledMethod::lem;
  std::vector<RandomNumber> numbers;
  std::vector<Correlation> correlations;
  std::vector<double>
      runout;  ///< mpm: distances whose exceedance probability is reported [m]; empty: chosen automatically
  double confidence = 0.95;  ///< level of the confidence interval [-]
};

template <>
inline constexpr auto choices<Distribution> = std::array{
    Choice{Distribution::normal, "normal", "Gauss, by mean and deviation"},
    Choice{Distribution::lognormal, "lognormal", "its logarithm is normal; mean and deviation of the value itself"},
    Choice{Distribution::triangular, "triangular", "from lowest over mode to highest"},
    Choice{Distribution::uniform, "uniform", "the same chance between lowest and highest"},
};
template <>
inline constexpr auto choices<SampledMethod> = std::array{
    Choice{SampledMethod::lem, "lem", "LEM on the surfaces of the case as the file has it"},
    Choice{SampledMethod::fem, "fem", "FEM"},
    Choice{SampledMethod::mpm, "mpm", "MPM, for the runout"},
};
template <>
inline constexpr auto choices<SamplePlan> = std::array{
    Choice{SamplePlan::latin_hypercube, "latin_hypercube", "each number once from each of as many equal shares"},
    Choice{SamplePlan::random, "random", "independent draws"},
};

void describe(Visitor& v, RandomNumber& r);

void describe(Visitor& v, Correlation& c);

struct Vary {
  std::string key;                  ///< dotted path of the key, as for --set
  std::vector<std::string> values;  ///< TOML texts of the values
  std::vector<std::string> names;   ///< labels of the values, as TOML texts; empty: "key = value"
};

enum class StudyMode { one_at_a_time, grid, together, sample };

struct Study {
  StudyMode mode = StudyMode::one_at_a_time;
  std::vector<Vary> vary;
  std::vector<double> factors;     ///< strength reduction factors whose displacements are tabulated [-]
  std::string base_name = "base";  ///< name of the unchanged case
  std::string reference = "base";  ///< variant that normalises the displacements of monitors
  std::string extrapolate;         ///< key, such as mesh.size, in which factors are extrapolated to zero; empty: none
  Sampling sampling;               ///< for mode = sample
};

template <>
inline constexpr auto choices<StudyMode> = std::array{
    Choice{StudyMode::one_at_a_time, "one_at_a_time", "each value alone, the other keys as in the file"},
    Choice{StudyMode::grid, "grid", "every combination of the values"},
    Choice{StudyMode::together, "together", "the first values of all keys make one variant, the second ones the next"},
    Choice{StudyMode::sample, "sample", "values drawn at random for the keys of [[study.random]]"},
};

void describe(Visitor& v, Vary& w);

void describe(Visitor& v, Study& s);

}  // namespace talus::input
