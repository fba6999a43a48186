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

void describe(auto& v, RandomNumber& r) {
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

void describe(auto& v, Correlation& c) {
  v.key("keys", c.keys, plain().required().example(R"(["materials.sand.cohesion", "materials.sand.friction_angle"])"),
        "Keys of two of the [[study.random]].");
  v.key("coefficient", c.coefficient, plain().above(-1).below(1).required().example("-0.5"),
        "Coefficient of correlation of the two, measured on their normal scores.");
}

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

void describe_sampling(auto& v, Study& s) {
  const auto sample = StudyMode::sample;
  Sampling& a = s.sampling;
  v.key("samples", a.samples, plain().at_least(2).allowed_with("mode", s.mode, sample), "Samples.");
  v.key("seed", a.seed, plain().allowed_with("mode", s.mode, sample),
        "Seed of the random numbers; the same seed brings the same samples.");
  v.key("plan", a.plan, plain().allowed_with("mode", s.mode, sample), "How samples are drawn.");
  v.key("method", a.method, plain().allowed_with("mode", s.mode, sample), "What calculates each sample.");
  v.key("confidence", a.confidence, plain().above(0).below(1).allowed_with("mode", s.mode, sample),
        "Confidence level of the interval of the probability of failure.");
  v.key("runout", a.runout, quantity("m").at_least(0).allowed_with("mode", s.mode, sample).example("[2, 5, 10]"),
        "For MPM: distances whose probability of exceedance is computed; empty: chosen from the samples.");
}

void describe(auto& v, Vary& w) {
  v.key("key", w.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key to vary, written as for --set.");
  TomlTexts values{w.values};
  v.key("values", values, plain().required().example("[5, 10, \"15 kPa\"]"), "Its values.");
  TomlTexts names{w.names};
  v.key("names", names, plain().example("[\"weak\", \"as tested\", \"strong\"]"),
        "Names of the variants with these values, for tables, charts and folders; if not given, \"cohesion = 5\".");
}

void describe(auto& v, Study& s) {
  v.key("mode", s.mode, plain(), "How the values of several keys are combined.");
  v.key("factors", s.factors, plain().above(0).example("[1.2, 1.4]"),
        "Strength reduction factors whose displacement the table of the study lists.");
  v.key("base_name", s.base_name, plain(), "Name of the case as the file has it.");
  v.key("reference", s.reference, plain(),
        "The variant that the displacements of the monitors are divided by: its name in the table, such as \"content = "
        "0.51\", or that of its folder.");
  v.key("extrapolate", s.extrapolate, plain().example(R"("mesh.size")"),
        "One of the varied keys, to whose value zero the factors of safety are extrapolated (Richardson).");
  describe_sampling(v, s);
  v.tables("vary", s.vary, 0, "A key and the values it takes in `talus study`.");
  v.tables("random", s.sampling.numbers, 0, "An uncertain number, for mode = \"sample\".");
  v.tables("correlation", s.sampling.correlations, 0, "Two of these numbers that go together.");
}

}  // namespace talus::input
