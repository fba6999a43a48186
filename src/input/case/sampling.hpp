// SPDX-License-Identifier: MIT
#pragma once
// [[study.random]] and [[study.correlation]]: uncertain numbers, for `talus study` with mode = "sample".

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

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

template <>
inline constexpr auto choices<Distribution> = std::array{
    Choice{Distribution::normal, "normal", "Gauss, by mean and deviation"},
    Choice{Distribution::lognormal, "lognormal", "its logarithm is normal; mean and deviation of the value itself"},
    Choice{Distribution::triangular, "triangular", "from lowest over mode to highest"},
    Choice{Distribution::uniform, "uniform", "the same chance between lowest and highest"},
};
template <>
inline constexpr auto choices<SampledMethod> = std::array{
    Choice{SampledMethod::lem, "lem", "slices on the surfaces of the case as the file has it"},
    Choice{SampledMethod::fem, "fem", "finite elements"},
    Choice{SampledMethod::mpm, "mpm", "material points, for the runout"},
};
template <>
inline constexpr auto choices<SamplePlan> = std::array{
    Choice{SamplePlan::latin_hypercube, "latin_hypercube", "each number once from each of as many equal shares"},
    Choice{SamplePlan::random, "random", "independent draws"},
};

template <class Visitor>
void describe(Visitor& v, RandomNumber& r) {
  using D = Distribution;
  const auto by_mean = {D::normal, D::lognormal};
  v.key("key", r.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key whose number is uncertain, written as for --set.");
  v.key("distribution", r.distribution, plain(), "How its values are distributed.");
  TomlText mean{r.mean}, deviation{r.deviation}, lowest{r.lowest}, mode{r.mode}, highest{r.highest};
  v.key("mean", mean, plain().allowed_with("distribution", r.distribution, by_mean).example(R"("10 kPa")"),
        "Mean, in the unit of the key or with a unit; if not given, the value of the key.");
  v.key("deviation", deviation, plain().allowed_with("distribution", r.distribution, by_mean).example("2"),
        "Standard deviation. Either this or `variation` is needed.");
  v.key("variation", r.variation, plain().above(0).allowed_with("distribution", r.distribution, by_mean).example("0.2"),
        "Coefficient of variation instead: standard deviation over mean.");
  v.key("lowest", lowest, plain().example("5"),
        "Lowest value; needed by triangular and uniform, and cuts the others off where it is given.");
  v.key("mode", mode, plain().allowed_with("distribution", r.distribution, D::triangular).example("10"),
        "The likeliest value; if not given, the value of the key.");
  v.key("highest", highest, plain().example("15"), "Highest value, like the lowest.");
}

template <class Visitor>
void describe(Visitor& v, Correlation& c) {
  v.key("keys", c.keys, plain().required().example(R"(["materials.sand.cohesion", "materials.sand.friction_angle"])"),
        "Keys of two of the [[study.random]].");
  v.key("coefficient", c.coefficient, plain().above(-1).below(1).required().example("-0.5"),
        "Coefficient of correlation of the two, measured on their normal scores.");
}

}  // namespace talus::input
