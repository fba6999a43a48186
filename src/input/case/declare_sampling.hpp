#pragma once
// [study] with mode = "sample": [[study.random]], [[study.correlation]], and how they are sampled.

#include "input/case/case.hpp"
#include "input/language/codec_list.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<StudyMode> = std::array{
    Choice{StudyMode::one_at_a_time, "one_at_a_time", "each value alone, the other keys as in the file"},
    Choice{StudyMode::grid, "grid", "every combination of the values"},
    Choice{StudyMode::together, "together", "the first values of all keys make one variant, the second ones the next"},
    Choice{StudyMode::sample, "sample", "values drawn at random for the keys of [[study.random]]"},
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

template <class Visitor>
void describe_sampling(Visitor& v, Study& s) {
  const auto sample = StudyMode::sample;
  Sampling& a = s.sampling;
  v.key("samples", a.samples, plain().at_least(2).allowed_with("mode", s.mode, sample), "Samples.");
  v.key("seed", a.seed, plain().allowed_with("mode", s.mode, sample),
        "Seed of the random numbers; the same seed brings the same samples.");
  v.key("plan", a.plan, plain().allowed_with("mode", s.mode, sample), "How samples are drawn.");
  v.key("method", a.method, plain().allowed_with("mode", s.mode, sample), "What calculates each sample.");
  v.key("confidence", a.confidence, plain().above(0).below(1).allowed_with("mode", s.mode, sample),
        "Probability that the interval given for the probability of failure holds it.");
  v.key("runout", a.runout, quantity("m").at_least(0).allowed_with("mode", s.mode, sample).example("[2, 5, 10]"),
        "With material points: distances whose probability of being exceeded is told; empty: chosen from the samples.");
}

}  // namespace talus::input
