// SPDX-License-Identifier: MIT
// Statistics of the samples (probabilities, moments and correlations of their results), and their tables study.md and
// samples.csv.
#include "study/sampling_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "output/files/history.hpp"
#include "output/plots/gnuplot.hpp"
#include "study/distributions.hpp"
#include "study/sampling.hpp"

namespace talus::study {

namespace {

constexpr double most_classes = 60;

std::vector<double> rank_values(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = 0.5 * static_cast<double>(i + end - 1);
    i = end;
  }
  return ranks;
}

/// Rounds up to 1, 2 or 5 times a power of ten.
double round_up(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (width <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace

results::SampledValues find_moments(const std::vector<double>& values) {
  results::SampledValues m;
  m.count = static_cast<long>(values.size());
  if (values.empty()) return m;
  const double n = static_cast<double>(values.size());
  m.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double second = 0, third = 0;
  for (const double x : values) {
    const double d = x - m.mean;
    second += d * d;
    third += d * d * d;
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  m.smallest = *low;
  m.largest = *high;
  if (n > 1) m.deviation = std::sqrt(second / (n - 1));
  if (n > 2 && second > 0) m.skewness = std::sqrt(n * (n - 1)) / (n - 2) * (third / n) / std::pow(second / n, 1.5);
  return m;
}

double find_quantile(std::vector<double> values, double p) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double at =
      std::clamp(p * static_cast<double>(values.size()) - 0.5, 0.0, static_cast<double>(values.size() - 1));
  const std::size_t i = static_cast<std::size_t>(at), next = std::min(i + 1, values.size() - 1);
  return values[i] + (at - static_cast<double>(i)) * (values[next] - values[i]);
}

double correlate(const std::vector<double>& a, const std::vector<double>& b) {
  const results::SampledValues ma = find_moments(a), mb = find_moments(b);
  double product = 0;
  for (std::size_t i = 0; i < a.size(); ++i) product += (a[i] - ma.mean) * (b[i] - mb.mean);
  const double scale = ma.deviation * mb.deviation * static_cast<double>(a.size() - 1);
  return scale > 0 ? product / scale : 0;
}

double correlate_ranks(const std::vector<double>& a, const std::vector<double>& b) {
  return correlate(rank_values(a), rank_values(b));
}

results::HistogramCounts count_classes(const std::vector<double>& values) {
  results::HistogramCounts h;
  if (values.empty()) return h;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double range = *high - *low;
  const double spread = find_quantile(values, 0.75) - find_quantile(values, 0.25);
  double width = 2 * spread / std::cbrt(static_cast<double>(values.size()));
  width = round_up(std::max(width, range / most_classes));
  if (!(range > 0)) width = round_up(0.01 * std::max(1.0, std::abs(*low)));
  const double first = std::floor(*low / width);
  const auto find_class = [&](double x) {
    return static_cast<std::size_t>(std::max(0.0, std::floor(x / width) - first));
  };
  h.counts.assign(find_class(*high) + 1, 0);
  for (std::size_t i = 0; i <= h.counts.size(); ++i) h.edges.push_back((first + static_cast<double>(i)) * width);
  for (const double x : values) ++h.counts[find_class(x)];
  return h;
}

results::SampleShare estimate_share(long count, long samples, double confidence) {
  const auto [lower, upper] = bound_share(count, samples, confidence);
  return {count, samples, samples > 0 ? static_cast<double>(count) / static_cast<double>(samples) : 0.0, lower, upper};
}

double estimate_error(const std::vector<double>& values, const std::vector<int>& first) {
  if (first.size() < 3) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> means;
  for (std::size_t r = 0; r + 1 < first.size(); ++r) {
    double sum = 0;
    for (int i = first[r]; i < first[r + 1]; ++i) sum += values[static_cast<std::size_t>(i)];
    means.push_back(sum / (first[r + 1] - first[r]));
  }
  return find_moments(means).deviation / std::sqrt(static_cast<double>(means.size()));
}

namespace {

constexpr double seconds_of_day = 86400;
/// Number of points of the convergence curve of the estimate.
constexpr std::size_t steps_of_growth = 40;
constexpr std::size_t distances_of_curve = 60;

/// The finite numbers of a list, and their indices.
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

/// Returns nullopt for a number that is not finite.
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

/// P(F < 1) with its interval, its standard error and its convergence.
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
  failure.interval = set.plan.latin
                         ? "Clopper and Pearson's interval of as many independent samples. Those of a Latin hypercube "
                           "scatter less or about as much (Owen 1997), so it contains the probability at least as "
                           "often as stated; the standard error is the scatter between independent hypercubes."
                         : "Clopper and Pearson's interval of independent samples: it contains the probability at "
                           "least as often as stated.";
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

/// Reliability indices from the mean and deviation of the sampled factors.
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

/// Computes the probability that the runout exceeds a distance, for several distances.
void make_runout_result(const input::Sampling& asked, const SampleSet& set, results::SampledRunout& runout) {
  const Present there(set.runout);
  const auto exceed = [&](double distance) {
    const auto count = std::count_if(there.values.begin(), there.values.end(), [&](double r) { return r > distance; });
    return estimate_share(static_cast<long>(count), static_cast<long>(there.values.size()), asked.confidence);
  };
  runout.values = describe_values(set.runout);
  const double end = runout.values.largest;
  for (std::size_t k = 0; k <= distances_of_curve; ++k) {
    const double distance =
        end * (static_cast<double>(k) / distances_of_curve);  // the last distance equals `end` exactly
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

// The following functions format study.md and samples.csv.

namespace {

std::string show_probability(double p) {
  return p == 0 ? "0" : p < 1e-3 ? fmt::format("{:.2e}", p) : fmt::format("{:.4g}", p);
}

std::string show_index(const std::optional<double>& index) {
  return index ? fmt::format("{:.3f}", *index) : "–";
}

std::string show_rank(const std::optional<std::vector<results::RankCorrelation>>& ranks, const std::string& key) {
  if (ranks)
    for (const results::RankCorrelation& r : *ranks)
      if (r.key == key && r.coefficient) return fmt::format("{:.3f}", *r.coefficient);
  return "–";
}

}  // namespace

std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling,
                                    const ShownUnit& length) {
  std::string text =
      fmt::format("# {}\n\n{} samples ({}, seed {}), {}: {:.1f} s.\n\n| number | distribution |\n|---|---|\n",
                  title.empty() ? "Study" : title, sampling.samples,
                  sampling.plan == results::SampleDraw::random ? "random" : "Latin hypercube", sampling.seed,
                  sampling.method_title, sampling.seconds);
  for (const results::UncertainNumber& n : sampling.numbers) text += fmt::format("| {} | {} |\n", n.key, n.text);
  for (const results::SampledCorrelation& c : sampling.correlations)
    text += fmt::format("\nCorrelation of {} and {}: {:g} asked, {:.3f} sampled.\n", c.keys[0], c.keys[1], c.asked,
                        c.sampled);
  if (const auto& f = sampling.factor; f && sampling.failure) {
    const results::FailureProbability& p = *sampling.failure;
    text += fmt::format(
        "\nFactor of safety: mean {:.3f}, deviation {:.3f}, skewness {:.2f}, {:.3f} to {:.3f}.\n\n"
        "Probability of failure P(F < 1) = {} ({} of {} samples), between {} and {} with {:g} % confidence; "
        "reliability index β = {}.\n",
        f->mean, f->deviation, f->skewness, f->smallest, f->largest, show_probability(p.share.probability),
        p.share.count, p.share.samples, show_probability(p.share.lower), show_probability(p.share.upper),
        100 * p.confidence, show_index(p.index));
  }
  if (const auto& f = sampling.first_order)
    text += fmt::format(
        "\nFirst order at the means: F = {:.3f}, deviation {:.4f}, β = {:.3f} (normal), {:.3f} (lognormal).\n",
        f->mean_factor, f->deviation, f->index_normal, f->index_lognormal);
  if (const auto& d = sampling.design_point) {
    text += fmt::format("\nMost probable failure (Hasofer and Lind): β = {:.3f}, probability {}, at", d->index,
                        show_probability(d->probability));
    for (const results::DesignPointValue& v : d->values)
      text += fmt::format("{} {} = {:.4g}{}", &v == d->values.data() ? "" : ",", v.name, v.value,
                          v.unit.empty() ? "" : " " + v.unit);
    text += ".\n";
  }
  if (sampling.tornado) {
    text +=
        "\n| number | at one deviation less | F | at one deviation more | F | rank correlation |\n"
        "|---|--:|--:|--:|--:|--:|\n";
    for (const results::TornadoBar& bar : *sampling.tornado)
      text +=
          fmt::format("| {} | {:.4g} {} | {:.3f} | {:.4g} {} | {:.3f} | {} |\n", bar.name, bar.low_value, bar.unit,
                      bar.low_factor, bar.high_value, bar.unit, bar.high_factor, show_rank(sampling.ranks, bar.key));
  }
  if (const auto& r = sampling.runout) {
    text += fmt::format(
        "\nRunout beyond the toe: mean {}, deviation {}, {:.3g} to {}.\n\n"
        "| farther than | probability | from | to |\n|--:|--:|--:|--:|\n",
        format_value(r->values.mean, length, 3), format_value(r->values.deviation, length, 3),
        r->values.smallest / length.si, format_value(r->values.largest, length, 3));
    for (const results::Exceedance& e : r->exceedance)
      text += fmt::format("| {} | {} | {} | {} |\n", format_value(e.distance, length, 3),
                          show_probability(e.share.probability), show_probability(e.share.lower),
                          show_probability(e.share.upper));
  }
  if (const auto& t = sampling.failure_time; t && t->count > 0)
    text += fmt::format("\nTime of failure of the {} samples that fail: mean {:.3g} days, {:.3g} to {:.3g} days.\n",
                        t->count, t->mean, t->smallest, t->largest);
  std::string notes;
  for (const std::string& note : sampling.notes) notes += "- " + note + "\n";
  return text + (notes.empty() ? "" : "\n" + notes);
}

std::string write_samples(const SampleSet& set) {
  std::string text = "sample";
  for (const results::UncertainNumber& n : set.summary.numbers)
    text += "," + output::quote_field(output::make_label(n.key, n.unit));
  if (!set.factor.empty()) text += ",factor of safety";
  if (!set.runout.empty()) text += ",runout beyond the toe [m]";
  if (!set.failure_time.empty()) text += ",time of failure [s]";
  text += '\n';
  const auto write = [](double x) { return std::isfinite(x) ? write_shortest(x) : std::string(); };
  for (std::size_t i = 0; i < set.size(); ++i) {
    text += std::to_string(i + 1);
    for (const auto& column : set.values) text += "," + write(column[i]);
    if (!set.factor.empty()) text += "," + write(set.factor[i]);
    if (!set.runout.empty()) text += "," + write(set.runout[i]);
    if (!set.failure_time.empty()) text += "," + write(set.failure_time[i]);
    text += '\n';
  }
  return text;
}

}  // namespace talus::study
