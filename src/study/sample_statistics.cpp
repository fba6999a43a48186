// SPDX-License-Identifier: MIT
#include "study/sample_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "study/normal_law.hpp"

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

/// The next 1, 2 or 5 times a power of ten.
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

}  // namespace talus::study
