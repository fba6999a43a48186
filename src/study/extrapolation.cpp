// SPDX-License-Identifier: MIT
#include "study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace talus::study {
namespace {

struct Line {
  double start = 0;  ///< at x = 0
  double slope = 0;
  double squares = 0;   ///< sum of the squared residuals
  double variance = 0;  ///< of `start`, over the variance of the residuals
};

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n, my = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  Line line;
  line.slope = sxy / sxx;
  line.start = my - line.slope * mx;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double r = y[i] - line.start - line.slope * x[i];
    line.squares += r * r;
  }
  line.variance = 1 / n + mx * mx / sxx;
  return line;
}

std::vector<double> raise(const std::vector<double>& sizes, double order) {
  std::vector<double> x;
  for (const double h : sizes) x.push_back(std::pow(h / sizes.front(), order));
  return x;
}

/// Returns the order with the smallest residual by golden section; nullopt if it lies at an end of the range.
std::optional<double> find_order(const std::vector<double>& sizes, const std::vector<double>& factors) {
  constexpr double lowest = 0.5, highest = 4, ratio = 0.6180339887498949, accuracy = 1e-4;
  const auto fault = [&](double p) { return fit_line(raise(sizes, p), factors).squares; };
  double a = lowest, b = highest;
  double c = b - ratio * (b - a), d = a + ratio * (b - a), fc = fault(c), fd = fault(d);
  while (b - a > accuracy) {
    if (fc < fd) {
      b = d;
      d = c;
      fd = fc;
      c = b - ratio * (b - a);
      fc = fault(c);
    } else {
      a = c;
      c = d;
      fc = fd;
      d = a + ratio * (b - a);
      fd = fault(d);
    }
  }
  const double p = 0.5 * (a + b);
  const bool at_end = p < lowest + 10 * accuracy || p > highest - 10 * accuracy;
  return at_end ? std::nullopt : std::optional(p);
}

/// Formats the other keys of a variant.
std::string describe_others(const StudyPlan& plan, const Variant& variant, std::size_t but) {
  std::string text;
  for (std::size_t k = 0; k < plan.names.size(); ++k) {
    if (k == but) continue;
    const std::string& unit = plan.summary.vary[k].unit;
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : ", ", plan.names[k], variant.values[k],
                        unit.empty() ? "" : " " + unit);
  }
  return text;
}

std::string write_number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "–";
}

}  // namespace

results::ExtrapolatedFactor extrapolate(const std::vector<double>& sizes, const std::vector<double>& factors) {
  if (sizes.size() != factors.size() || sizes.size() < 2)
    fail_input("an extrapolation needs the factors of two sizes or more");
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  results::ExtrapolatedFactor e;
  for (const std::size_t i : order) {
    if (!(sizes[i] > 0) || (!e.sizes.empty() && sizes[i] == e.sizes.back()))
      fail_input("an extrapolation needs sizes that are positive and differ");
    e.sizes.push_back(sizes[i]);
    e.factors.push_back(factors[i]);
  }
  const std::size_t n = e.sizes.size();
  const Line line = fit_line(e.sizes, e.factors);
  e.linear = line.start;
  if (n >= 3) e.standard_error = std::sqrt(line.squares / static_cast<double>(n - 2) * line.variance);
  e.finest_pair = fit_line({e.sizes[n - 2], e.sizes[n - 1]}, {e.factors[n - 2], e.factors[n - 1]}).start;
  if (n >= 4) e.order = find_order(e.sizes, e.factors);
  if (e.order) e.by_order = fit_line(raise(e.sizes, *e.order), e.factors).start;
  return e;
}

std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<results::StudyColumn>& table) {
  if (!plan.extrapolated) return std::nullopt;
  const std::size_t key = *plan.extrapolated;
  results::StudyExtrapolation found{plan.summary.vary[key].key, plan.summary.vary[key].unit, {}};
  for (const results::StudyColumn& column : table) {
    if (column.kind != results::ColumnKind::factor) continue;
    std::vector<std::string> order;  // groups in the order of their first variant
    std::map<std::string, std::map<double, double>> groups;
    for (std::size_t i = 0; i < column.cells.size(); ++i) {
      if (column.cells[i].full.empty()) continue;
      const std::string others = describe_others(plan, plan.variants[i], key);
      const double size = read_number(plan.variants[i].values[key]);
      if (!(size > 0)) continue;
      if (!groups.contains(others)) order.push_back(others);
      groups[others].try_emplace(size, read_number(column.cells[i].full));
    }
    for (const std::string& name : order) {
      if (groups[name].size() < 2) continue;
      std::vector<double> sizes, factors;
      for (const auto& [size, factor] : groups[name]) {
        sizes.push_back(size);
        factors.push_back(factor);
      }
      // A factor that does not depend on the key, such as that of LEM on the element size, is not extrapolated.
      const auto [low, high] = std::minmax_element(factors.begin(), factors.end());
      if (!(*low < *high)) continue;
      results::ExtrapolatedFactor& e = found.factors.emplace_back(extrapolate(sizes, factors));
      e.criterion = column.title;
      e.by = column.by;
      e.variant = name;
    }
  }
  return found;
}

std::string write_extrapolation_markdown(const results::StudyExtrapolation& extrapolation, const std::string& name) {
  if (extrapolation.factors.empty()) return "";
  const std::string unit = extrapolation.unit.empty() ? "" : " " + extrapolation.unit;
  std::string text = fmt::format("\n## Extrapolated to {} = 0\n\n", name);
  text +=
      "| factor | variant | from sizes | coarsest | finest | line through all | ± | line through the finest two | "
      "order p | with p |\n|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const results::ExtrapolatedFactor& e : extrapolation.factors)
    text += fmt::format("| {} | {} | {:g}–{:g}{} ({}) | {:.3f} | {:.3f} | {:.3f} | {} | {:.3f} | {} | {} |\n",
                        e.criterion, e.variant.empty() ? "–" : e.variant, e.sizes.front(), e.sizes.back(), unit,
                        e.sizes.size(), e.factors.front(), e.factors.back(), e.linear, write_number(e.standard_error),
                        e.finest_pair, e.order ? fmt::format("{:.2f}", *e.order) : "–", write_number(e.by_order));
  text +=
      "\n±: standard error from the scatter of the meshes about the line. The order p is the exponent of h that fits "
      "best, where there are four sizes and it lies within 1/2 and 4.\n";
  return text;
}

}  // namespace talus::study
