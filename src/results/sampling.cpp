// SPDX-License-Identifier: MIT
#include "results/sampling.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, SampleMoments& r) {
  v.key("mean", r.mean, {"", "mean", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation", can_be_nan});
  v.key("smallest", r.smallest, {"", "smallest", can_be_nan});
  v.key("largest", r.largest, {"", "largest", can_be_nan});
}

void describe(Visitor& v, UncertainNumber& r) {
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

void describe(Visitor& v, SampledCorrelation& r) {
  v.key("keys", r.keys, {"", "keys"});
  v.key("asked", r.asked, {"", "correlation that was asked for"});
  v.key("sampled", r.sampled, {"", "correlation of the samples", can_be_nan});
}

void describe(Visitor& v, Quantile& r) {
  v.key("share", r.share, {"", "share of the samples below it"});
  v.key("value", r.value, {"", "value"});
}

void describe(Visitor& v, HistogramCounts& r) {
  v.key("edges", r.edges, {"", "limits of the classes"});
  v.key("counts", r.counts, {"", "samples in each class"});
}

void describe(Visitor& v, SampledValues& r) {
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

void describe(Visitor& v, SampleShare& r) {
  v.key("count", r.count, {"", "samples that count"});
  v.key("samples", r.samples, {"", "samples"});
  v.key("probability", r.probability, {"", "probability"});
  v.key("lower", r.lower, {"", "lower end of its interval"});
  v.key("upper", r.upper, {"", "upper end of its interval"});
}

void describe(Visitor& v, FailureProbability& r) {
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

void describe(Visitor& v, FirstOrderEstimate& r) {
  v.key("mean_factor", r.mean_factor, {"", "factor at the means", can_be_nan});
  v.key("deviation", r.deviation, {"", "standard deviation of the factor", can_be_nan});
  v.key("index_normal", r.index_normal, {"", "reliability index, normal factor", can_be_nan});
  v.key("index_lognormal", r.index_lognormal, {"", "reliability index, lognormal factor", can_be_nan});
}

void describe(Visitor& v, DesignPointValue& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("value", r.value, {"", "value", can_be_nan});
  v.key("importance", r.importance, {"", "importance", can_be_nan});
}

void describe(Visitor& v, DesignPointEstimate& r) {
  v.key("index", r.index, {"", "reliability index", can_be_nan});
  v.key("probability", r.probability, {"", "probability of failure", can_be_nan});
  v.key("converged", r.converged, {"", "whether the search converged"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("factor", r.factor, {"", "factor at the design point", can_be_nan});
  v.key("values", r.values, {"", "design point"});
}

void describe(Visitor& v, FittedLaw& r) {
  v.key("index", r.index, {"", "reliability index", can_be_nan});
  v.key("probability", r.probability, {"", "probability of failure", can_be_nan});
}

void describe(Visitor& v, FittedLaws& r) {
  v.key("normal", r.normal, {"", "normal"});
  v.key("lognormal", r.lognormal, {"", "lognormal"});
}

void describe(Visitor& v, TornadoBar& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("low_value", r.low_value, {"", "low value", can_be_nan});
  v.key("high_value", r.high_value, {"", "high value", can_be_nan});
  v.key("low_factor", r.low_factor, {"", "factor at the low value", can_be_nan});
  v.key("high_factor", r.high_factor, {"", "factor at the high value", can_be_nan});
}

void describe(Visitor& v, RankCorrelation& r) {
  v.key("key", r.key, {"", "key"});
  v.key("name", r.name, {"", "name"});
  v.key("coefficient", r.coefficient, {"", "Spearman's coefficient"});
}

void describe(Visitor& v, SurfaceCheck& r) {
  v.key("samples", r.samples, {"", "samples that were searched"});
  v.key("largest", r.largest, {"", "largest difference", can_be_nan});
  v.key("mean", r.mean, {"", "mean difference", can_be_nan});
}

void describe(Visitor& v, Exceedance& r) {
  describe(v, r.share);
  v.key("distance", r.distance, {"m", "distance"});
}

void describe(Visitor& v, SampledRunout& r) {
  describe(v, r.values);
  v.key("name", r.name, {"", "result"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("curve", r.curve, {"", "distance, probability and its interval"});
  v.key("exceedance", r.exceedance, {"", "probability of chosen distances"});
  v.key("ranks", r.ranks, {"", "rank correlations"});
}

void describe(Visitor& v, Sampling& r) {
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
