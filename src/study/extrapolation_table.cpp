// The factors of a study over the key that it extrapolates.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "study/extrapolation.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

std::optional<std::size_t> find_key(const StudyPlan& plan) {
  for (std::size_t k = 0; k < plan.keys.size(); ++k)
    if (plan.keys[k].path == plan.extrapolate) return k;
  return std::nullopt;
}

/// The other keys of a variant, as people read them.
std::string describe_others(const StudyPlan& plan, const Variant& variant, std::size_t but) {
  std::string text;
  for (std::size_t k = 0; k < plan.keys.size(); ++k) {
    if (k == but) continue;
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : ", ", plan.keys[k].name, variant.values[k],
                        plan.keys[k].unit.empty() ? "" : " " + plan.keys[k].unit);
  }
  return text;
}

std::string write_number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "–";
}

}  // namespace

std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<StudyRow>& rows) {
  const auto key = find_key(plan);
  if (!key) return std::nullopt;
  results::StudyExtrapolation found{plan.extrapolate, plan.keys[*key].unit, {}};
  for (const results::StudyColumn& column : make_study_table(plan, rows)) {
    if (column.kind != results::ColumnKind::factor) continue;
    std::vector<std::string> order;  // groups as they come
    std::map<std::string, std::map<double, double>> groups;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (column.cells[i].full.empty()) continue;
      const std::string others = describe_others(plan, plan.variants[i], *key);
      const double size = std::strtod(plan.variants[i].values[*key].c_str(), nullptr);
      if (!(size > 0)) continue;
      if (!groups.contains(others)) order.push_back(others);
      groups[others].try_emplace(size, std::strtod(column.cells[i].full.c_str(), nullptr));
    }
    for (const std::string& name : order) {
      if (groups[name].size() < 2) continue;
      std::vector<double> sizes, factors;
      for (const auto& [size, factor] : groups[name]) {
        sizes.push_back(size);
        factors.push_back(factor);
      }
      // A factor that does not know the key, such as that of slices over the element size, has nothing to extrapolate.
      const auto [low, high] = std::minmax_element(factors.begin(), factors.end());
      if (!(*low < *high)) continue;
      const Extrapolation e = extrapolate(sizes, factors);
      found.factors.push_back({column.title, column.by, name, e.sizes, e.factors, e.linear, e.standard_error,
                               e.finest_pair, e.order, e.by_order});
    }
  }
  return found;
}

std::string write_extrapolation_markdown(const StudyPlan& plan,
                                         const std::optional<results::StudyExtrapolation>& extrapolation) {
  const auto key = find_key(plan);
  if (!key || !extrapolation || extrapolation->factors.empty()) return "";
  const StudyKey& size = plan.keys[*key];
  const std::string unit = size.unit.empty() ? "" : " " + size.unit;
  std::string text = fmt::format("\n## Extrapolated to {} = 0\n\n", size.name);
  text +=
      "| factor | variant | from sizes | coarsest | finest | line through all | ± | line through the finest two | "
      "order p "
      "| with p |\n|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const results::ExtrapolatedFactor& e : extrapolation->factors)
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
