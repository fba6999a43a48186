#include "study/sampling_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/normal_law.hpp"
#include "study/sample_statistics.hpp"

namespace talus::study {
namespace {

using nlohmann::json;

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

json to_json(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json describe_share(const Share& share) {
  return {{"count", share.count},
          {"samples", share.samples},
          {"probability", share.probability},
          {"lower", share.interval[0]},
          {"upper", share.interval[1]}};
}

json describe_numbers(const SampleSet& set) {
  json list = json::array();
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j) {
    const SampledNumber& n = set.sampled.numbers[j];
    const Moments found = find_moments(set.values[j]);
    list.push_back({{"key", n.key},
                    {"name", n.name},
                    {"unit", n.unit},
                    {"distribution", name_distribution(n.marginal.kind)},
                    {"text", n.text},
                    {"mean", n.marginal.find_mean()},
                    {"deviation", n.marginal.find_deviation()},
                    {"lowest", to_json(n.marginal.lowest)},
                    {"highest", to_json(n.marginal.highest)},
                    {"sampled",
                     {{"mean", found.mean},
                      {"deviation", found.deviation},
                      {"smallest", found.smallest},
                      {"largest", found.largest}}}});
  }
  return list;
}

json describe_correlations(const SampleSet& set) {
  json list = json::array();
  const std::size_t n = set.sampled.numbers.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (const double asked = set.sampled.correlation[i * n + j]; asked != 0)
        list.push_back({{"keys", {set.sampled.numbers[i].key, set.sampled.numbers[j].key}},
                        {"asked", asked},
                        {"sampled", correlate(set.scores[i], set.scores[j])}});
  return list;
}

json describe_histogram(const std::vector<double>& values) {
  const Histogram h = count_classes(values);
  return {{"edges", h.edges}, {"counts", h.counts}};
}

json describe_values(const std::vector<double>& all) {
  const Present there(all);
  const Moments m = find_moments(there.values);
  json quantiles = json::array();
  for (const double p : {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
    quantiles.push_back({{"share", p}, {"value", to_json(find_quantile(there.values, p))}});
  return {{"count", m.count},
          {"none", static_cast<long>(all.size()) - m.count},
          {"mean", m.mean},
          {"deviation", m.deviation},
          {"variation", m.mean != 0 ? json(m.deviation / m.mean) : json(nullptr)},
          {"skewness", m.skewness},
          {"smallest", m.smallest},
          {"largest", m.largest},
          {"quantiles", quantiles},
          {"histogram", describe_histogram(there.values)}};
}

/// P(F < 1), its interval, its standard error, and how it settled.
json describe_failure(const input::Sampling& asked, const SampleSet& set) {
  const Present there(set.factor);
  std::vector<double> failed;
  for (const double f : there.values) failed.push_back(f < 1 ? 1 : 0);
  const auto count = static_cast<long>(std::count(failed.begin(), failed.end(), 1.0));
  const Share share = estimate_share(count, static_cast<long>(failed.size()), asked.confidence);
  json block = describe_share(share);
  block["limit"] = 1;
  block["confidence"] = asked.confidence;
  block["index"] = to_json(-find_normal_score(share.probability));
  block["index_lower"] = to_json(-find_normal_score(share.interval[1]));
  block["index_upper"] = to_json(-find_normal_score(share.interval[0]));
  block["standard_error"] = nullptr;
  const double p = share.probability, n = static_cast<double>(share.samples);
  if (!set.plan.latin && n > 0) block["standard_error"] = std::sqrt(p * (1 - p) / n);
  if (set.plan.replicates > 1 && there.values.size() == set.factor.size()) {
    std::vector<int> first;
    for (int r = 0; r <= set.plan.replicates; ++r) first.push_back(find_first(set.plan, r));
    block["standard_error"] = to_json(estimate_error(failed, first));
  }
  block["interval"] =
      set.plan.latin
          ? "Clopper and Pearson's interval of as many independent samples. Those of a Latin hypercube scatter less or "
            "about as much (Owen 1997), so it holds the probability at least as often as it says; the standard error "
            "is "
            "the scatter between hypercubes drawn for themselves."
          : "Clopper and Pearson's interval of independent samples: it holds the probability at least as often as it "
            "says.";
  json growth = json::array();
  long so_far = 0;
  std::size_t next = 1;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    so_far += failed[i] > 0 ? 1 : 0;
    if (i + 1 < next * failed.size() / steps_of_growth && i + 1 != failed.size()) continue;
    while (next * failed.size() / steps_of_growth <= i + 1) ++next;
    const Share s = estimate_share(so_far, static_cast<long>(i + 1), asked.confidence);
    growth.push_back({i + 1, s.probability, s.interval[0], s.interval[1]});
  }
  block["growth"] = growth;
  if (set.check && set.check->largest > 0) {
    const double share_of = 1 / (1 + set.check->largest);
    const auto shifted =
        std::count_if(there.values.begin(), there.values.end(), [&](double f) { return f * share_of < 1; });
    block["with_largest_difference"] = n > 0 ? static_cast<double>(shifted) / n : 0;
  }
  return block;
}

/// Indices that rest on the mean and deviation of the sampled factors.
json describe_fits(const std::vector<double>& all) {
  const Moments m = find_moments(Present(all).values);
  if (m.deviation <= 0 || m.mean <= 0) return nullptr;
  const double v = m.deviation / m.mean, spread = std::sqrt(std::log1p(v * v));
  const double normal = (m.mean - 1) / m.deviation, lognormal = std::log(m.mean / std::sqrt(1 + v * v)) / spread;
  return {{"normal", {{"index", normal}, {"probability", find_normal_probability(-normal)}}},
          {"lognormal", {{"index", lognormal}, {"probability", find_normal_probability(-lognormal)}}}};
}

json describe_first_order(const SampleSet& set) {
  if (!set.first_order) return nullptr;
  const FirstOrder& f = *set.first_order;
  return {{"mean_factor", f.mean_factor},
          {"deviation", f.deviation},
          {"index_normal", f.index_normal},
          {"index_lognormal", f.index_lognormal}};
}

json describe_design_point(const SampleSet& set) {
  if (!set.design_point) return nullptr;
  const DesignPoint& d = *set.design_point;
  json values = json::array();
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j)
    values.push_back({{"key", set.sampled.numbers[j].key},
                      {"name", set.sampled.numbers[j].name},
                      {"unit", set.sampled.numbers[j].unit},
                      {"value", d.values[j]},
                      {"importance", d.importance[j]}});
  return {{"index", d.index},         {"probability", find_normal_probability(-d.index)},
          {"converged", d.converged}, {"iterations", d.iterations},
          {"factor", d.factor},       {"values", values}};
}

/// Longest bar first.
json describe_tornado(const SampleSet& set) {
  if (!set.first_order) return nullptr;
  std::vector<std::size_t> order;
  for (std::size_t j = 0; j < set.sampled.numbers.size(); ++j) order.push_back(j);
  const auto length = [&](std::size_t j) {
    const Sensitivity& s = set.first_order->sensitivities[j];
    return std::abs(s.high_factor - s.low_factor);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
  json list = json::array();
  for (const std::size_t j : order) {
    const Sensitivity& s = set.first_order->sensitivities[j];
    const SampledNumber& n = set.sampled.numbers[j];
    list.push_back({{"key", n.key},
                    {"name", n.name},
                    {"unit", n.unit},
                    {"low_value", s.low_value},
                    {"high_value", s.high_value},
                    {"low_factor", s.low_factor},
                    {"high_factor", s.high_factor}});
  }
  return list;
}

json describe_ranks(const SampleSet& set, const std::vector<double>& result) {
  const Present there(result);
  json list = json::array();
  for (std::size_t j = 0; j < set.values.size(); ++j) {
    std::vector<double> column;
    for (const std::size_t i : there.rows) column.push_back(set.values[j][i]);
    list.push_back(
        {{"key", set.sampled.numbers[j].key},
         {"name", set.sampled.numbers[j].name},
         {"coefficient", there.values.size() > 2 ? json(correlate_ranks(column, there.values)) : json(nullptr)}});
  }
  return list;
}

/// How probable it is that the soil comes farther than a distance.
json describe_runout(const input::Sampling& asked, const SampleSet& set) {
  if (set.runout.empty()) return nullptr;
  const Present there(set.runout);
  const auto exceed = [&](double distance) {
    const auto count = std::count_if(there.values.begin(), there.values.end(), [&](double r) { return r > distance; });
    return estimate_share(static_cast<long>(count), static_cast<long>(there.values.size()), asked.confidence);
  };
  json block = describe_values(set.runout);
  block["name"] = set.runout_name;
  block["unit"] = "m";
  json curve = json::array();
  const double end = find_moments(there.values).largest;
  for (std::size_t k = 0; k <= distances_of_curve; ++k) {
    const double distance = end * static_cast<double>(k) / distances_of_curve;
    const Share s = exceed(distance);
    curve.push_back({distance, s.probability, s.interval[0], s.interval[1]});
  }
  block["curve"] = curve;
  std::vector<double> distances = asked.runout;
  if (distances.empty())
    for (const double share : {0.0, 0.25, 0.5, 0.75}) distances.push_back(share * end);
  json exceedance = json::array();
  for (const double distance : distances) {
    json s = describe_share(exceed(distance));
    s["distance"] = distance;
    exceedance.push_back(std::move(s));
  }
  block["exceedance"] = exceedance;
  block["ranks"] = describe_ranks(set, set.runout);
  return block;
}

}  // namespace

json describe_sampling(const input::Sampling& asked, const SampleSet& set) {
  const char* const methods[] = {"lem", "fem", "mpm"};
  json block = {{"samples", set.plan.samples},
                {"seed", set.plan.seed},
                {"plan", set.plan.latin ? "latin_hypercube" : "random"},
                {"replicates", set.plan.replicates},
                {"method", methods[static_cast<int>(set.method)]},
                {"method_title", set.method_title},
                {"seconds", set.seconds},
                {"numbers", describe_numbers(set)},
                {"correlations", describe_correlations(set)},
                {"factor", nullptr},
                {"failure", nullptr},
                {"first_order", describe_first_order(set)},
                {"design_point", describe_design_point(set)},
                {"fits", nullptr},
                {"tornado", describe_tornado(set)},
                {"ranks", nullptr},
                {"surfaces", set.surfaces},
                {"check", nullptr},
                {"runout", describe_runout(asked, set)},
                {"notes", set.notes},
                {"samples_file", "samples.csv"}};
  if (!set.factor.empty()) {
    block["factor"] = describe_values(set.factor);
    block["failure"] = describe_failure(asked, set);
    block["fits"] = describe_fits(set.factor);
    block["ranks"] = describe_ranks(set, set.factor);
    if (const long none = block["factor"]["none"]; none > 0)
      block["notes"].push_back(fmt::format("{} of {} samples have no factor and are not counted.", none, set.size()));
  }
  if (set.check)
    block["check"] = {{"samples", set.check->samples}, {"largest", set.check->largest}, {"mean", set.check->mean}};
  return block;
}

}  // namespace talus::study
