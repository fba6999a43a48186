// SPDX-License-Identifier: MIT
#pragma once
// Results of a probabilistic analysis: samples, factors of safety, probability of failure, and sensitivities.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "results/comparison.hpp"

namespace talus::results {

enum class SampleDraw { random, latin_hypercube };
template <>
inline constexpr auto words<SampleDraw> = std::array{"random", "latin_hypercube"};

struct SampleMoments {
  double mean = 0, deviation = 0, smallest = 0, largest = 0;
};
void describe(auto& v, As<SampleMoments> auto& r) {
  v.key("mean", r.mean, {"", "mean", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation", can_be_nan});
  v.key("smallest", r.smallest, {"", "smallest", can_be_nan});
  v.key("largest", r.largest, {"", "largest", can_be_nan});
}

/// An uncertain parameter, in its unit.
struct UncertainNumber {
  std::string key, name, unit, distribution, text;
  double mean = 0, deviation = 0;
  std::optional<double> lowest, highest;  ///< truncation limits; nullopt: unlimited
  SampleMoments sampled;
};
void describe(auto& v, As<UncertainNumber> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("distribution", r.distribution, {"", "distribution"});
  v.key("text", r.text, {"", "as the case has it"});
  v.key("mean", r.mean, {"", "mean", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation", can_be_nan});
  v.key("lowest", r.lowest, {"", "lower limit"});
  v.key("highest", r.highest, {"", "upper limit"});
  v.key("sampled", r.sampled, {"", "of the samples"});
}

struct SampledCorrelation {
  std::array<std::string, 2> keys;
  double asked = 0, sampled = 0;
};
void describe(auto& v, As<SampledCorrelation> auto& r) {
  v.key("keys", r.keys, {"", "keys"});
  v.key("asked", r.asked, {"", "correlation that was asked for"});
  v.key("sampled", r.sampled, {"", "correlation of the samples", can_be_nan});
}

struct Quantile {
  double share = 0;
  std::optional<double> value;
};
void describe(auto& v, As<Quantile> auto& r) {
  v.key("share", r.share, {"", "share of the samples below it"});
  v.key("value", r.value, {"", "value"});
}

struct HistogramCounts {
  std::vector<double> edges;
  std::vector<long> counts;
};
void describe(auto& v, As<HistogramCounts> auto& r) {
  v.key("edges", r.edges, {"", "limits of the classes"});
  v.key("counts", r.counts, {"", "samples in each class"});
}

/// Distribution of a result over the samples.
struct SampledValues {
  long count = 0, none = 0;
  double mean = 0, deviation = 0;
  std::optional<double> variation;
  double skewness = 0, smallest = 0, largest = 0;
  std::vector<Quantile> quantiles;
  HistogramCounts histogram;
};
void describe(auto& v, As<SampledValues> auto& r) {
  v.key("count", r.count, {"", "samples with a value"});
  v.key("none", r.none, {"", "samples without one"});
  v.key("mean", r.mean, {"", "mean", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation", can_be_nan});
  v.key("variation", r.variation, {"", "coefficient of variation"});
  v.key("skewness", r.skewness, {"", "skewness", can_be_nan});
  v.key("smallest", r.smallest, {"", "smallest", can_be_nan});
  v.key("largest", r.largest, {"", "largest", can_be_nan});
  v.key("quantiles", r.quantiles, {"", "quantiles"});
  v.key("histogram", r.histogram, {"", "histogram"});
}

/// Fraction of the samples with a property, with its confidence interval.
struct SampleShare {
  long count = 0, samples = 0;
  double probability = 0, lower = 0, upper = 0;
};
void describe(auto& v, As<SampleShare> auto& r) {
  v.key("count", r.count, {"", "samples that count"});
  v.key("samples", r.samples, {"", "samples"});
  v.key("probability", r.probability, {"", "probability"});
  v.key("lower", r.lower, {"", "lower end of its interval"});
  v.key("upper", r.upper, {"", "upper end of its interval"});
}

/// Probability of failure P(F < limit).
struct FailureProbability {
  SampleShare share;
  double limit = 1, confidence = 0;
  std::optional<double> index, index_lower, index_upper, standard_error;
  std::string interval;                           ///< kind of the confidence interval
  std::vector<std::array<double, 4>> growth;      ///< convergence: number of samples, probability, lower and upper end
  std::optional<double> with_largest_difference;  ///< with all factors lowered by SurfaceCheck::largest
};
void describe(auto& v, As<FailureProbability> auto& r) {
  describe(v, r.share);
  v.key("limit", r.limit, {"", "factor below which a sample fails"});
  v.key("confidence", r.confidence, {"", "confidence of the interval"});
  v.key("index", r.index, {"", "reliability index"});
  v.key("index_lower", r.index_lower, {"", "lower end of its interval"});
  v.key("index_upper", r.index_upper, {"", "upper end of its interval"});
  v.key("standard_error", r.standard_error, {"", "standard error of the probability"});
  v.key("interval", r.interval, {"", "what the interval is"});
  v.key("growth", r.growth, {"", "samples so far, probability and its interval"});
  v.maybe("with_largest_difference", r.with_largest_difference,
          {"", "probability with the largest difference of the check"});
}

/// First-order second-moment estimate at the mean values (FOSM).
struct FirstOrderEstimate {
  double mean_factor = 0, deviation = 0, index_normal = 0, index_lognormal = 0;
};
void describe(auto& v, As<FirstOrderEstimate> auto& r) {
  v.key("mean_factor", r.mean_factor, {"", "factor at the means", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation of the factor", can_be_nan});
  v.key("index_normal", r.index_normal, {"", "reliability index, normal factor", can_be_nan});
  v.key("index_lognormal", r.index_lognormal, {"", "reliability index, lognormal factor", can_be_nan});
}

struct DesignPointValue {
  std::string key, name, unit;
  double value = 0, importance = 0;
};
void describe(auto& v, As<DesignPointValue> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("value", r.value, {"", "value", can_be_nan});
  v.key("importance", r.importance, {"", "importance", can_be_nan});
}

/// First-order reliability method (FORM): reliability index and design point.
struct DesignPointEstimate {
  double index = 0, probability = 0;
  bool converged = false;
  int iterations = 0;
  double factor = 0;
  std::vector<DesignPointValue> values;
};
void describe(auto& v, As<DesignPointEstimate> auto& r) {
  v.key("index", r.index, {"", "reliability index", can_be_nan});
  v.key("probability", r.probability, {"", "probability of failure", can_be_nan});
  v.key("converged", r.converged, {"", "whether the search converged"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("factor", r.factor, {"", "factor at the design point", can_be_nan});
  v.key("values", r.values, {"", "design point"});
}

struct FittedLaw {
  double index = 0, probability = 0;
};
void describe(auto& v, As<FittedLaw> auto& r) {
  v.key("index", r.index, {"", "reliability index", can_be_nan});
  v.key("probability", r.probability, {"", "probability of failure", can_be_nan});
}

/// Distributions fitted to the mean and the standard deviation of the sampled factors.
struct FittedLaws {
  FittedLaw normal, lognormal;
};
void describe(auto& v, As<FittedLaws> auto& r) {
  v.key("normal", r.normal, {"", "normal"});
  v.key("lognormal", r.lognormal, {"", "lognormal"});
}

/// One bar of the tornado diagram.
struct TornadoBar {
  std::string key, name, unit;
  double low_value = 0, high_value = 0, low_factor = 0, high_factor = 0;
};
void describe(auto& v, As<TornadoBar> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("low_value", r.low_value, {"", "low value", can_be_nan});
  v.key("high_value", r.high_value, {"", "high value", can_be_nan});
  v.key("low_factor", r.low_factor, {"", "factor at the low value", can_be_nan});
  v.key("high_factor", r.high_factor, {"", "factor at the high value", can_be_nan});
}

struct RankCorrelation {
  std::string key, name;
  std::optional<double> coefficient;
};
void describe(auto& v, As<RankCorrelation> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("coefficient", r.coefficient, {"", "Spearman's coefficient"});
}

/// Comparison of the factors on the common set of surfaces with those of separate searches.
struct SurfaceCheck {
  int samples = 0;
  double largest = 0, mean = 0;  ///< relative excess of the factor on the common surfaces
};
void describe(auto& v, As<SurfaceCheck> auto& r) {
  v.key("samples", r.samples, {"", "samples that were searched"});
  v.key("largest", r.largest, {"", "largest difference", can_be_nan});
  v.key("mean", r.mean, {"", "mean difference", can_be_nan});
}

/// Probability that the runout exceeds a distance.
struct Exceedance {
  SampleShare share;
  double distance = 0;  ///< [m]
};
void describe(auto& v, As<Exceedance> auto& r) {
  describe(v, r.share);
  v.key("distance", r.distance, {"m", "distance"});
}

struct SampledRunout {
  SampledValues values;
  std::string name, unit = "m";
  std::vector<std::array<double, 4>> curve;  ///< distance [m], probability, lower and upper end
  std::vector<Exceedance> exceedance;
  std::vector<RankCorrelation> ranks;
};
void describe(auto& v, As<SampledRunout> auto& r) {
  describe(v, r.values);
  v.key("name", r.name, {"", "result"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("curve", r.curve, {"", "distance, probability and its interval"});
  v.key("exceedance", r.exceedance, {"", "probability of chosen distances"});
  v.key("ranks", r.ranks, {"", "rank correlations"});
}

/// "sampling" of study.json.
struct Sampling {
  int samples = 0;
  std::uint64_t seed = 0;
  SampleDraw plan = SampleDraw::random;
  int replicates = 1;
  Method method = Method::lem;
  std::string method_title;
  double seconds = 0;
  std::vector<UncertainNumber> numbers;
  std::vector<SampledCorrelation> correlations;
  std::optional<SampledValues> factor;
  std::optional<FailureProbability> failure;
  std::optional<FirstOrderEstimate> first_order;
  std::optional<DesignPointEstimate> design_point;
  std::optional<FittedLaws> fits;
  std::optional<std::vector<TornadoBar>> tornado;
  std::optional<std::vector<RankCorrelation>> ranks;
  int surfaces = 0;  ///< number of surfaces on which every sample is evaluated; 0: separate search for each sample
  std::optional<SurfaceCheck> check;
  std::optional<SampledRunout> runout;
  std::optional<SampledValues> failure_time;  ///< over the samples that fail within the timeline [day]
  std::vector<std::string> notes;
  std::string samples_file;
};
void describe(auto& v, As<Sampling> auto& r) {
  v.key("samples", r.samples, {"", "samples"});
  v.key("seed", r.seed, {"", "seed"});
  v.key("plan", r.plan, {"", "how samples were drawn"});
  v.key("replicates", r.replicates, {"", "hypercubes that were drawn for themselves"});
  v.key("method", r.method, {"", "method"});
  v.key("method_title", r.method_title, {"", "method in words"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("numbers", r.numbers, {"", "uncertain numbers"});
  v.key("correlations", r.correlations, {"", "correlations"});
  v.key("factor", r.factor, {"", "distribution of the factor of safety"});
  v.key("failure", r.failure, {"", "probability of failure"});
  v.key("first_order", r.first_order, {"", "first-order second-moment estimate"});
  v.key("design_point", r.design_point, {"", "first-order reliability method"});
  v.key("fits", r.fits, {"", "laws with the mean and deviation of the samples"});
  v.key("tornado", r.tornado, {"", "factor over each number"});
  v.key("ranks", r.ranks, {"", "rank correlations with the factor"});
  v.key("surfaces", r.surfaces, {"", "surfaces that every sample was evaluated on"});
  v.key("check", r.check, {"", "quick factors against searches"});
  v.key("runout", r.runout, {"", "distribution of the runout"});
  v.key("failure_time", r.failure_time, {"day", "time of failure of the samples that fail within the timeline"});
  v.key("notes", r.notes, {"", "notes"});
  v.key("samples_file", r.samples_file, {"", "file of the samples"});
}

}  // namespace talus::results
