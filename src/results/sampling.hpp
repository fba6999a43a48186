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
void describe(Visitor& v, SampleMoments& r);

/// An uncertain parameter, in its unit.
struct UncertainNumber {
  std::string key, name, unit, distribution, text;
  double mean = 0, deviation = 0;
  std::optional<double> lowest, highest;  ///< truncation limits; nullopt: unlimited
  SampleMoments sampled;
};
void describe(Visitor& v, UncertainNumber& r);

struct SampledCorrelation {
  std::array<std::string, 2> keys;
  double asked = 0, sampled = 0;
};
void describe(Visitor& v, SampledCorrelation& r);

struct Quantile {
  double share = 0;
  std::optional<double> value;
};
void describe(Visitor& v, Quantile& r);

struct HistogramCounts {
  std::vector<double> edges;
  std::vector<long> counts;
};
void describe(Visitor& v, HistogramCounts& r);

/// Distribution of a result over the samples.
struct SampledValues {
  long count = 0, none = 0;
  double mean = 0, deviation = 0;
  std::optional<double> variation;
  double skewness = 0, smallest = 0, largest = 0;
  std::vector<Quantile> quantiles;
  HistogramCounts histogram;
};
void describe(Visitor& v, SampledValues& r);

/// Fraction of the samples with a property, with its confidence interval.
struct SampleShare {
  long count = 0, samples = 0;
  double probability = 0, lower = 0, upper = 0;
};
void describe(Visitor& v, SampleShare& r);

/// Probability of failure P(F < limit).
struct FailureProbability {
  SampleShare share;
  double limit = 1, confidence = 0;
  std::optional<double> index, index_lower, index_upper, standard_error;
  std::string interval;                           ///< kind of the confidence interval
  std::vector<std::array<double, 4>> growth;      ///< convergence: number of samples, probability, lower and upper end
  std::optional<double> with_largest_difference;  ///< with all factors lowered by SurfaceCheck::largest
};
void describe(Visitor& v, FailureProbability& r);

/// First-order second-moment estimate at the mean values (FOSM).
struct FirstOrderEstimate {
  double mean_factor = 0, deviation = 0, index_normal = 0, index_lognormal = 0;
};
void describe(Visitor& v, FirstOrderEstimate& r);

struct DesignPointValue {
  std::string key, name, unit;
  double value = 0, importance = 0;
};
void describe(Visitor& v, DesignPointValue& r);

/// First-order reliability method (FORM): reliability index and design point.
struct DesignPointEstimate {
  double index = 0, probability = 0;
  bool converged = false;
  int iterations = 0;
  double factor = 0;
  std::vector<DesignPointValue> values;
};
void describe(Visitor& v, DesignPointEstimate& r);

struct FittedLaw {
  double index = 0, probability = 0;
};
void describe(Visitor& v, FittedLaw& r);

/// Distributions fitted to the mean and the standard deviation of the sampled factors.
struct FittedLaws {
  FittedLaw normal, lognormal;
};
void describe(Visitor& v, FittedLaws& r);

/// One bar of the tornado diagram.
struct TornadoBar {
  std::string key, name, unit;
  double low_value = 0, high_value = 0, low_factor = 0, high_factor = 0;
};
void describe(Visitor& v, TornadoBar& r);

struct RankCorrelation {
  std::string key, name;
  std::optional<double> coefficient;
};
void describe(Visitor& v, RankCorrelation& r);

/// Comparison of the factors on the common set of surfaces with those of separate searches.
struct SurfaceCheck {
  int samples = 0;
  double largest = 0, mean = 0;  ///< relative excess of the factor on the common surfaces
};
void describe(Visitor& v, SurfaceCheck& r);

/// Probability that the runout exceeds a distance.
struct Exceedance {
  SampleShare share;
  double distance = 0;  ///< [m]
};
void describe(Visitor& v, Exceedance& r);

struct SampledRunout {
  SampledValues values;
  std::string name, unit = "m";
  std::vector<std::array<double, 4>> curve;  ///< distance [m], probability, lower and upper end
  std::vector<Exceedance> exceedance;
  std::vector<RankCorrelation> ranks;
};
void describe(Visitor& v, SampledRunout& r);

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
void describe(Visitor& v, Sampling& r);

}  // namespace talus::results
