#include "study/sampling_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/normal_law.hpp"
#include "study/sample_statistics.hpp"

namespace talus::study {
namespace {

/// How often the estimate is told as the samples grow.
constexpr std::size_t steps_of_growth = 40;
constexpr std::size_t distances_of_curve = 60;

/// The numbers of a list that are there, and which they are.
struct Present {
  explicit Present(const std::vector<double>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!std::isfinite(all[i])) continue;
      values.push_back(all[i]);
      rows.push_back(i);
    }
  }
  std::vector<double> values;
  std::vector<std::size_t> rows;
};

/// Nothing for a number that is not finite.
std::optional<double> keep_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

results::SampleShare describe_share(const Share& share) {
  return {share.count, share.samples, share.probability, share.interval[0], share.interval[1]};
}

std::vector<results::UncertainNumber> describe_numbers(const SampleSet& set) {
  std::vector<results::UncertainNumber> list;
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j) {
    const SampledNumber& n = set.sampled.numbers[j];
    const Moments found = find_moments(set.values[j]);
    list.push_back({n.key,
                    n.name,
                    n.unit,
                    name_distribution(n.marginal.kind),
                    n.text,
                    n.marginal.find_mean(),
                    n.marginal.find_deviation(),
                    keep_finite(n.marginal.lowest),
                    keep_finite(n.marginal.highest),
                    {found.mean, found.deviation, found.smallest, found.largest}});
  }
  return list;
}

std::vector<results::SampledCorrelation> describe_correlations(const SampleSet& set) {
  std::vector<results::SampledCorrelation> list;
  const std::size_t n = set.sampled.numbers.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (const double asked = set.sampled.correlation[i * n + j]; asked != 0)
        list.push_back(
            {{set.sampled.numbers[i].key, set.sampled.numbers[j].key}, asked, correlate(set.scores[i], set.scores[j])});
  return list;
}

results::SampledValues describe_values(const std::vector<double>& all) {
  const Present there(all);
  const Moments m = find_moments(there.values);
  const Histogram h = count_classes(there.values);
  results::SampledValues values;
  values.count = m.count;
  values.none = static_cast<long>(all.size()) - m.count;
  values.mean = m.mean;
  values.deviation = m.deviation;
  if (m.mean != 0) values.variation = m.deviation / m.mean;
  values.skewness = m.skewness;
  values.smallest = m.smallest;
  values.largest = m.largest;
  for (const double p : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
    values.quantiles.push_back({p, keep_finite(find_quantile(there.values, p))});
  values.histogram = {h.edges, h.counts};
  return values;
}

/// P(F < 1), its interval, its standard error, and how it settled.
results::FailureProbability describe_failure(const input::Sampling& asked, const SampleSet& set) {
  const Present there(set.factor);
  std::vector<double> failed;
  for (const double f : there.values) failed.push_back(f < 1 ? 1 : 0);
  const auto count = static_cast<long>(std::count(failed.begin(), failed.end(), 1.0));
  const Share share = estimate_share(count, static_cast<long>(failed.size()), asked.confidence);
  results::FailureProbability failure;
  failure.share = describe_share(share);
  failure.confidence = asked.confidence;
  failure.index = keep_finite(-find_normal_score(share.probability));
  failure.index_lower = keep_finite(-find_normal_score(share.interval[1]));
  failure.index_upper = keep_finite(-find_normal_score(share.interval[0]));
  const double p = share.probability, n = static_cast<double>(share.samples);
  if (!set.plan.latin && n > 0) failure.standard_error = std::sqrt(p * (1 - p) / n);
  if (set.plan.replicates > 1 && there.values.size() == set.factor.size()) {
    std::vector<int> first;
    for (int r = 0; r <= set.plan.replicates; ++r) first.push_back(find_first(set.plan, r));
    failure.standard_error = keep_finite(estimate_error(failed, first));
  }
  failure.interval =
      set.plan.latin
          ? "Clopper and Pearson's interval of as many independent samples. Those of a Latin hypercube scatter less or "
            "about as much (Owen 1997), so it holds the probability at least as often as it says; the standard error "
            "is "
            "the scatter between hypercubes drawn for themselves."
          : "Clopper and Pearson's interval of independent samples: it holds the probability at least as often as it "
            "says.";
  long so_far = 0;
  std::size_t next = 1;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    so_far += failed[i] > 0 ? 1 : 0;
    if (i + 1 < next * failed.size() / steps_of_growth && i + 1 != failed.size()) continue;
    while (next * failed.size() / steps_of_growth <= i + 1) ++next;
    const Share s = estimate_share(so_far, static_cast<long>(i + 1), asked.confidence);
    failure.growth.push_back({static_cast<double>(i + 1), s.probability, s.interval[0], s.interval[1]});
  }
  if (set.check && set.check->largest > 0) {
    const double share_of = 1 / (1 + set.check->largest);
    const auto shifted =
        std::count_if(there.values.begin(), there.values.end(), [&](double f) { return f * share_of < 1; });
    failure.with_largest_difference = n > 0 ? static_cast<double>(shifted) / n : 0;
  }
  return failure;
}

/// Indices that rest on the mean and deviation of the sampled factors.
std::optional<results::FittedLaws> describe_fits(const std::vector<double>& all) {
  const Moments m = find_moments(Present(all).values);
  if (m.deviation <= 0 || m.mean <= 0) return std::nullopt;
  const double v = m.deviation / m.mean, spread = std::sqrt(std::log1p(v * v));
  const double normal = (m.mean - 1) / m.deviation, lognormal = std::log(m.mean / std::sqrt(1 + v * v)) / spread;
  return results::FittedLaws{{normal, find_normal_probability(-normal)},
                             {lognormal, find_normal_probability(-lognormal)}};
}

std::optional<results::FirstOrderEstimate> describe_first_order(const SampleSet& set) {
  if (!set.first_order) return std::nullopt;
  const FirstOrder& f = *set.first_order;
  return results::FirstOrderEstimate{f.mean_factor, f.deviation, f.index_normal, f.index_lognormal};
}

std::optional<results::DesignPointEstimate> describe_design_point(const SampleSet& set) {
  if (!set.design_point) return std::nullopt;
  const DesignPoint& d = *set.design_point;
  results::DesignPointEstimate estimate{d.index, find_normal_probability(-d.index), d.converged, d.iterations, d.factor,
                                        {}};
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j) {
    const SampledNumber& n = set.sampled.numbers[j];
    estimate.values.push_back({n.key, n.name, n.unit, d.values[j], d.importance[j]});
  }
  return estimate;
}

/// Longest bar first.
std::optional<std::vector<results::TornadoBar>> describe_tornado(const SampleSet& set) {
  if (!set.first_order) return std::nullopt;
  std::vector<results::TornadoBar> bars;
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j) {
    const Sensitivity& s = set.first_order->sensitivities[j];
    const SampledNumber& n = set.sampled.numbers[j];
    bars.push_back({n.key, n.name, n.unit, s.low_value, s.high_value, s.low_factor, s.high_factor});
  }
  const auto length = [](const results::TornadoBar& bar) { return std::abs(bar.high_factor - bar.low_factor); };
  std::stable_sort(bars.begin(), bars.end(), [&](const auto& a, const auto& b) { return length(a) > length(b); });
  return bars;
}

std::vector<results::RankCorrelation> describe_ranks(const SampleSet& set, const std::vector<double>& result) {
  const Present there(result);
  std::vector<results::RankCorrelation> list;
  for (std::size_t j = 0; j < set.values.size(); ++j) {
    std::vector<double> column;
    for (const std::size_t i : there.rows) column.push_back(set.values[j][i]);
    auto& rank = list.emplace_back(
        results::RankCorrelation{set.sampled.numbers[j].key, set.sampled.numbers[j].name, std::nullopt});
    if (there.values.size() > 2) rank.coefficient = correlate_ranks(column, there.values);
  }
  return list;
}

/// How probable it is that the soil comes farther than a distance.
std::optional<results::SampledRunout> describe_runout(const input::Sampling& asked, const SampleSet& set) {
  if (set.runout.empty()) return std::nullopt;
  const Present there(set.runout);
  const auto exceed = [&](double distance) {
    const auto count = std::count_if(there.values.begin(), there.values.end(), [&](double r) { return r > distance; });
    return estimate_share(static_cast<long>(count), static_cast<long>(there.values.size()), asked.confidence);
  };
  results::SampledRunout runout;
  runout.values = describe_values(set.runout);
  runout.name = set.runout_name;
  const double end = find_moments(there.values).largest;
  for (std::size_t k = 0; k <= distances_of_curve; ++k) {
    const double distance = end * static_cast<double>(k) / distances_of_curve;
    const Share s = exceed(distance);
    runout.curve.push_back({distance, s.probability, s.interval[0], s.interval[1]});
  }
  std::vector<double> distances = asked.runout;
  if (distances.empty())
    for (const double share : {0.0, 0.25, 0.5, 0.75}) distances.push_back(share * end);
  for (const double distance : distances) runout.exceedance.push_back({describe_share(exceed(distance)), distance});
  runout.ranks = describe_ranks(set, set.runout);
  return runout;
}

}  // namespace

results::Sampling describe_sampling(const input::Sampling& asked, const SampleSet& set) {
  results::Sampling sampling;
  sampling.samples = set.plan.samples;
  sampling.seed = set.plan.seed;
  sampling.plan = set.plan.latin ? results::SampleDraw::latin_hypercube : results::SampleDraw::random;
  sampling.replicates = set.plan.replicates;
  sampling.method = static_cast<Method>(set.method);  // the words of [study] are those of the methods
  sampling.method_title = set.method_title;
  sampling.seconds = set.seconds;
  sampling.numbers = describe_numbers(set);
  sampling.correlations = describe_correlations(set);
  sampling.first_order = describe_first_order(set);
  sampling.design_point = describe_design_point(set);
  sampling.tornado = describe_tornado(set);
  sampling.surfaces = set.surfaces;
  sampling.check = set.check;
  sampling.runout = describe_runout(asked, set);
  sampling.notes = set.notes;
  sampling.samples_file = "samples.csv";
  if (set.factor.empty()) return sampling;
  sampling.factor = describe_values(set.factor);
  sampling.failure = describe_failure(asked, set);
  sampling.fits = describe_fits(set.factor);
  sampling.ranks = describe_ranks(set, set.factor);
  if (const long none = sampling.factor->none; none > 0)
    sampling.notes.push_back(fmt::format("{} of {} samples have no factor and are not counted.", none, set.size()));
  return sampling;
}

}  // namespace talus::study
