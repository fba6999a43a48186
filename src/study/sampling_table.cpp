// SPDX-License-Identifier: MIT
// Statistics of samples: shares, moments and correlations of their results.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/normal_law.hpp"
#include "study/sample_statistics.hpp"
#include "study/sampling.hpp"

namespace talus::study {
namespace {

constexpr double seconds_of_day = 86400;
/// How often the estimate is told as the samples grow.
constexpr std::size_t steps_of_growth = 40;
constexpr std::size_t distances_of_curve = 60;

/// The finite numbers of a list, and their places.
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
  results::SampledValues values = find_moments(there.values);
  values.none = static_cast<long>(all.size()) - values.count;
  if (values.mean != 0) values.variation = values.deviation / values.mean;
  for (const double p : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
    values.quantiles.push_back({p, keep_finite(find_quantile(there.values, p))});
  values.histogram = count_classes(there.values);
  return values;
}

/// P(F < 1), its interval, its standard error, and how it converged.
results::FailureProbability describe_failure(const input::Sampling& asked, const SampleSet& set) {
  const Present there(set.factor);
  std::vector<double> failed;
  for (const double f : there.values) failed.push_back(f < 1 ? 1 : 0);
  const auto count = static_cast<long>(std::count(failed.begin(), failed.end(), 1.0));
  results::FailureProbability failure;
  const results::SampleShare& share = failure.share =
      estimate_share(count, static_cast<long>(failed.size()), asked.confidence);
  failure.confidence = asked.confidence;
  failure.index = keep_finite(-find_normal_score(share.probability));
  failure.index_lower = keep_finite(-find_normal_score(share.upper));
  failure.index_upper = keep_finite(-find_normal_score(share.lower));
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
            "about as much (Owen 1997), so it contains the probability at least as often as stated; the standard error "
            "is the scatter between independent hypercubes."
          : "Clopper and Pearson's interval of independent samples: it contains the probability at least as often as "
            "stated.";
  long so_far = 0;
  std::size_t next = 1;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    so_far += failed[i] > 0 ? 1 : 0;
    if (i + 1 < next * failed.size() / steps_of_growth && i + 1 != failed.size()) continue;
    while (next * failed.size() / steps_of_growth <= i + 1) ++next;
    const results::SampleShare s = estimate_share(so_far, static_cast<long>(i + 1), asked.confidence);
    failure.growth.push_back({static_cast<double>(i + 1), s.probability, s.lower, s.upper});
  }
  if (const auto& check = set.summary.check; check && check->largest > 0) {
    const double share_of = 1 / (1 + check->largest);
    const auto shifted =
        std::count_if(there.values.begin(), there.values.end(), [&](double f) { return f * share_of < 1; });
    failure.with_largest_difference = n > 0 ? static_cast<double>(shifted) / n : 0;
  }
  return failure;
}

/// Indices that rest on the mean and deviation of the sampled factors.
std::optional<results::FittedLaws> describe_fits(const results::SampledValues& factor) {
  if (factor.deviation <= 0 || factor.mean <= 0) return std::nullopt;
  const double normal = (factor.mean - 1) / factor.deviation;
  const double lognormal = find_lognormal_index(factor.mean, factor.deviation);
  return results::FittedLaws{{normal, find_normal_probability(-normal)},
                             {lognormal, find_normal_probability(-lognormal)}};
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
void make_runout_result(const input::Sampling& asked, const SampleSet& set, results::SampledRunout& runout) {
  const Present there(set.runout);
  const auto exceed = [&](double distance) {
    const auto count = std::count_if(there.values.begin(), there.values.end(), [&](double r) { return r > distance; });
    return estimate_share(static_cast<long>(count), static_cast<long>(there.values.size()), asked.confidence);
  };
  runout.values = describe_values(set.runout);
  const double end = runout.values.largest;
  for (std::size_t k = 0; k <= distances_of_curve; ++k) {
    const double distance = end * (static_cast<double>(k) / distances_of_curve);  // the last is the end to the last bit
    const results::SampleShare s = exceed(distance);
    runout.curve.push_back({distance, s.probability, s.lower, s.upper});
  }
  std::vector<double> distances = asked.runout;
  if (distances.empty())
    for (const double share : {0.0, 0.25, 0.5, 0.75}) distances.push_back(share * end);
  for (const double distance : distances) runout.exceedance.push_back({exceed(distance), distance});
  runout.ranks = describe_ranks(set, set.runout);
}

}  // namespace

void make_samples_result(const input::Sampling& asked, SampleSet& set) {
  results::Sampling& out = set.summary;
  out.correlations = describe_correlations(set);
  if (std::any_of(set.failure_time.begin(), set.failure_time.end(), [](double t) { return std::isfinite(t); })) {
    std::vector<double> days = set.failure_time;
    for (double& time : days) time /= seconds_of_day;
    out.failure_time = describe_values(days);
  }
  if (out.runout) make_runout_result(asked, set, *out.runout);
  out.samples_file = "samples.csv";
  if (set.factor.empty()) return;
  out.factor = describe_values(set.factor);
  out.failure = describe_failure(asked, set);
  out.fits = describe_fits(*out.factor);
  out.ranks = describe_ranks(set, set.factor);
  if (const long none = out.factor->none; none > 0)
    out.notes.push_back(fmt::format("{} of {} samples have no factor and are not counted.", none, set.size()));
}

}  // namespace talus::study
