// SPDX-License-Identifier: MIT
#include "report/content/method_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "report/content/choices.hpp"
#include "report/folder/numbers.hpp"
#include "results/governing.hpp"

namespace talus::report {

using nlohmann::json;
using results::FactorMeasure;
using results::MethodRow;
using results::SurfaceSource;
using results::to_word;
using results::Topic;

namespace {

json write(std::optional<double> value) {
  return value ? json(*value) : json();
}

bool is_associated(const MethodRow& row) {
  return results::from_word<results::Flow>(row.name) == results::Flow::associated;
}

/// Returns a text such as "Spencer, critical circle".
std::string describe(const MethodRow& row) {
  return row.criterion.empty() ? row.label : row.label + ", " + row.criterion;
}

/// Returns true for limit analysis and FEM, whose intervals are rounded outward; others are rounded to the nearest.
bool is_rounded_outward(const MethodRow& row) {
  return row.method == Method::bounds || row.method == Method::fem;
}
std::optional<double> take_lower(const MethodRow& row) {
  return row.lower && is_rounded_outward(row) ? results::show_lower(*row.lower) : row.lower;
}
std::optional<double> take_upper(const MethodRow& row) {
  return row.upper && is_rounded_outward(row) ? results::show_upper(*row.upper) : row.upper;
}

/// Returns the name in [[compare]]: "lem.noncircular.spencer", "lem.handed[fem.band].spencer", "fem.by_displacement".
std::string name_result(const MethodRow& row) {
  if (row.method == Method::bounds) return "bounds";
  if (row.method == Method::fem)
    return fmt::format("fem.{}{}", is_associated(row) ? "associated." : "",
                       row.measure == FactorMeasure::displacement ? "by_displacement" : "factor");
  switch (row.source) {
    case SurfaceSource::none:
      return "lem." + row.name;
    case SurfaceSource::handed:
      return fmt::format("lem.handed[{}].{}", row.surface, row.name);
    default:
      return row.surface;
  }
}

/// Returns true for a surface found by a search of LEM, not one that was given to it.
bool is_critical(const MethodRow& row) {
  const SurfaceSource source = row.source;
  return row.method == Method::lem && (source == SurfaceSource::critical || source == SurfaceSource::noncircular);
}

Factor make_factor(const MethodRow& row) {
  Factor factor;
  factor.method = row.method;
  factor.name = name_result(row);
  factor.title = describe(row);
  factor.value = row.factor;
  factor.lower = take_lower(row);
  factor.upper = take_upper(row);
  factor.note = row.note;
  factor.source = row.source;
  if (row.method == Method::lem) {
    factor.slice_method = results::from_word<SliceMethod>(row.name);
  } else if (row.method == Method::fem) {
    factor.flow = results::from_word<results::Flow>(row.name);
    factor.measure = row.measure;
  }
  return factor;
}

/// Returns the word of the method of slices, of the flow rule or of the criterion.
std::string name_kind(const Factor& factor) {
  if (factor.slice_method) return to_word(*factor.slice_method);
  if (factor.flow) return to_word(*factor.flow);
  return factor.by ? to_word(*factor.by) : "";
}

/// Marks the main factor of FEM: the first by loss of equilibrium, or the first of all.
void mark_elements(std::vector<Factor>& factors) {
  Factor* main = nullptr;
  for (Factor& factor : factors)
    if (factor.method == Method::fem && factor.value &&
        (main == nullptr ||
         (factor.measure == FactorMeasure::equilibrium && main->measure != FactorMeasure::equilibrium)))
      main = &factor;
  if (main != nullptr) main->is_main = true;
}

/// Returns "to 0.4 %", or "to three digits" for a difference below 0.05 %.
std::string format_closeness(double difference) {
  const double percent = 100 * std::abs(difference);
  return percent < 0.05 ? "to three digits" : fmt::format("to {:.1f} %", percent);
}

/// Returns the title of a method as a heading: "Limit analysis".
std::string make_heading(Method method) {
  std::string title = get_title(method);
  char& first = title.front();
  if (first >= 'a' && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
  return title;
}

std::string name_topic(Topic topic) {
  switch (topic) {
    case Topic::slices:
      return make_heading(Method::lem);
    case Topic::elements:
      return make_heading(Method::fem);
    case Topic::bounds:
      return make_heading(Method::bounds);
    case Topic::points:
      return make_heading(Method::mpm);
    case Topic::mechanism:
      return "Mechanism";
    case Topic::seconds:
      return "Computing time";
    default:
      return "Agreement";
  }
}

/// Groups remarks by topic, in the order in which the topics first occur.
json group_remarks(const std::vector<results::Remark>& remarks) {
  std::vector<Topic> topics;
  for (const results::Remark& remark : remarks)
    if (std::find(topics.begin(), topics.end(), remark.topic) == topics.end()) topics.push_back(remark.topic);
  json groups = json::array();
  for (const Topic topic : topics) {
    json sentences = json::array();
    for (const results::Remark& remark : remarks)
      if (remark.topic == topic) sentences.push_back(remark.text);
    groups.push_back({{"topic", name_topic(topic)}, {"sentences", sentences}});
  }
  return groups;
}

/// Replaces the main factor of LEM and of FEM by the smallest over time; factors at time 0 are labelled as such.
void lead_with_timeline(const results::Timeline& timeline, std::vector<Factor>& factors) {
  for (Factor& factor : factors) {
    if (factor.method == Method::lem) factor.is_main = false;
    factor.title += ", at time 0";
  }
  if (const results::TimedReduction* elements = results::find_least_reduction(timeline)) {
    Factor later;
    later.method = Method::fem;
    later.name = "timeline.elements";
    later.title = fmt::format("at {}", results::format_moment(timeline, elements->time));
    later.value = elements->runs.front().factor;
    if (const auto& interval = elements->runs.front().interval) {
      later.lower = results::show_lower(interval->lower);
      later.upper = results::show_upper(interval->upper);
    }
    later.flow = elements->runs.front().flow;
    later.measure = FactorMeasure::equilibrium;
    later.is_main = true;
    factors.insert(factors.begin(), std::move(later));
  }
  if (!timeline.least) return;
  const auto at = std::find_if(timeline.factors.begin(), timeline.factors.end(),
                               [&](const results::TimedFactor& f) { return f.time == timeline.least_time; });
  Factor least;
  least.method = Method::lem;
  least.name = "timeline.least";
  least.title = fmt::format("least in time, at {}: {}, {}", results::format_moment(timeline, at->time),
                            at->surface.title, at->source);
  least.value = timeline.least;
  least.note = results::format_failure(timeline);
  least.is_main = true;
  factors.insert(factors.begin(), std::move(least));
}

/// Lists for each method the least factor at the ends of the stages.
std::vector<Factor> list_stage_factors(const results::Construction& construction) {
  std::vector<Factor> factors;
  for (const Method method : {Method::lem, Method::fem, Method::bounds}) {
    const results::StageFactor* least = nullptr;
    std::string stage;
    for (const results::ConstructionStage& s : construction.stages)
      for (const results::StageFactor& f : s.factors)
        if (f.method == method && f.factor && (least == nullptr || *f.factor < *least->factor))
          least = &f, stage = s.name;
    if (least == nullptr) continue;
    Factor factor;
    factor.method = method;
    factor.name = "construction.least";
    factor.title = fmt::format("least, at the end of stage '{}': {}", stage, least->title);
    factor.value = least->factor;
    if (least->lower) factor.lower = results::show_lower(*least->lower);
    if (least->upper) factor.upper = results::show_upper(*least->upper);
    factor.is_main = construction.least.has_value();
    factors.push_back(std::move(factor));
  }
  return factors;
}

}  // namespace

json list_method_titles() {
  json titles;
  for (const Method method : {Method::lem, Method::fem, Method::bounds, Method::mpm})
    titles[to_word(method)] = make_heading(method);
  return titles;
}

json read_methods(const ResultFolder& folder) {
  if (!folder.run.methods || !asks_for_others(folder)) return {};
  json read{{"reading", group_remarks(folder.run.methods->remarks)}};
  if (const auto governing = results::find_governing_surface(folder.run)) read["governing"] = governing->name;
  return read;
}

json to_json(const Factor& factor) {
  json block{{"method", to_word(factor.method)},
             {"by", name_kind(factor)},
             {"name", factor.name},
             {"title", factor.title},
             {"value", write(factor.value)},
             {"lower", write(factor.lower)},
             {"upper", write(factor.upper)},
             {"note", factor.note},
             {"main", factor.is_main}};
  if (factor.source) block["source"] = to_word(*factor.source);
  if (factor.measure) block["measure"] = to_word(*factor.measure);
  if (factor.water) block["water"] = input::get_word(*factor.water);
  return block;
}

std::vector<Factor> list_other_factors(const results::RunResult& run) {
  std::vector<Factor> factors;
  if (run.construction) return list_stage_factors(*run.construction);
  if (!run.methods) return factors;
  const std::vector<MethodRow>& rows = run.methods->table;
  const bool has_critical = std::any_of(rows.begin(), rows.end(), is_critical);
  const std::optional<results::GoverningSurface> governing = results::find_governing_surface(run);
  for (const MethodRow& row : rows) {
    if (row.method == Method::mpm) continue;
    if (row.method == Method::lem && has_critical && !is_critical(row) &&
        (!governing || row.surface != governing->name))
      continue;
    factors.push_back(make_factor(row));
  }
  if (governing || (run.slices && run.slices->referee))
    for (Factor& factor : factors)
      if (governing || factor.method == Method::lem)
        factor.is_main = governing && factor.name == governing->name && factor.value;
  if (run.timeline) lead_with_timeline(*run.timeline, factors);
  std::stable_sort(factors.begin(), factors.end(), [](const Factor& a, const Factor& b) {
    return std::pair(a.method, !a.is_main) < std::pair(b.method, !b.is_main);
  });
  mark_elements(factors);
  return factors;
}

std::string format_main_factors(const results::RunResult& run, const std::vector<Factor>& factors) {
  std::vector<const Factor*> mains;
  for (const Factor& factor : factors)
    if (factor.is_main && factor.value) mains.push_back(&factor);
  if (mains.empty()) return "";
  // The smallest factor governs and is listed first.
  std::stable_sort(mains.begin(), mains.end(), [](auto* a, auto* b) { return *a->value < *b->value; });
  std::vector<std::string> parts;
  for (const Factor* factor : mains)
    parts.push_back(fmt::format("{:.3f} by {} ({})", *factor->value, get_title(factor->method), factor->title));
  return fmt::format("The factor of safety{} is {}.", has_design_values(run) ? " with design values" : "",
                     join_words(parts));
}

std::string format_referee(const results::RunResult& run) {
  if (!run.slices || run.slices->error || !run.slices->referee) return "";
  if (!run.slices->referee->is_interval()) {
    // With supports the lower bound may be the answer.
    const std::string why = results::describe_ruled_out(run);
    return why.empty() ? ""
                       : fmt::format(
                             "For ψ = φ the factor of safety is at least {:.3f} by limit analysis. That is the "
                             "answer: {}.",
                             results::show_lower(*run.slices->referee->lower), why);
  }
  const double lower = results::show_lower(*run.slices->referee->lower),
               upper = results::show_upper(*run.slices->referee->upper);
  if (run.slices->referee->upper_only)
    return fmt::format("For ψ = φ {} is at most {:.3f} by limit analysis; it has no lower bound: {}.",
                       run.timeline ? "the factor at time 0" : "it", upper, *run.slices->referee->upper_only);
  // Separate bounds in the answer may be based on another tensile strength.
  if (run.timeline || (run.bounds && !run.bounds->error))
    return fmt::format("{} of the soil of limit equilibrium (ψ = φ, tension up to c/tan φ) gives {:.3f} to {:.3f}.",
                       run.timeline ? "At time 0 limit analysis" : "Limit analysis", lower, upper);
  if (run.slices->referee->is_wide())
    return fmt::format(
        "For ψ = φ the factor of safety lies between {:.3f} and {:.3f} by limit analysis, too wide an interval to rule "
        "out any factor as too low.",
        lower, upper);
  if (results::find_governing_surface(run))
    return fmt::format("For ψ = φ it lies between {:.3f} and {:.3f} by limit analysis.", lower, upper);
  return fmt::format(
      "For ψ = φ the factor of safety lies between {:.3f} and {:.3f} by limit analysis. That is the answer: {}.", lower,
      upper, results::describe_ruled_out(run));
}

std::string format_proven(const results::RunResult& run) {
  if (!run.bounds || run.bounds->error) return "";
  const results::BoundsResult& bounds = *run.bounds;
  const std::string soil = bounds.is_davis
                               ? std::string("For soil with the strength of Davis, an estimate for ψ < φ, it")
                               : std::string(run.timeline ? "At time 0, for" : "For") + " ψ = φ the factor of safety";
  const double lower = results::show_lower(bounds.lower.value_or(0)),
               upper = results::show_upper(bounds.upper.value_or(0));
  if (bounds.is_interval())
    return fmt::format("{} lies between {:.3f} and {:.3f} by limit analysis.", soil, lower, upper);
  if (bounds.lower) return fmt::format("{} is at least {:.3f} by limit analysis.", soil, lower);
  if (bounds.upper) return fmt::format("{} is at most {:.3f} by limit analysis.", soil, upper);
  return fmt::format("Limit analysis found no bound of the factor of safety: {}.", bounds.no_upper);
}

std::string format_agreement(const std::vector<Factor>& factors) {
  // Differences below `close` are not explained.
  constexpr double close = 0.02, far = 0.1;
  std::vector<double> values;
  const Factor *given = nullptr, *associated = nullptr, *points = nullptr;
  for (const Factor& factor : factors) {
    if (!factor.value) continue;
    if (factor.is_main) values.push_back(*factor.value);
    if (factor.measure == FactorMeasure::equilibrium)
      (factor.flow == results::Flow::associated ? associated : given) = &factor;
    if (factor.by == results::CriterionKind::frozen) points = &factor;
  }
  if (values.size() < 2) return "";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double spread = *high / *low - 1;
  if (spread < close)
    return fmt::format("The {} methods agree {}.", values.size() == 2 ? "two" : "three", format_closeness(spread));
  std::vector<std::string> reasons;
  if (given != nullptr && associated != nullptr) {
    const double a = *given->value, b = *associated->value;
    if (std::abs(a / b - 1) > close / 2)
      reasons.push_back(
          fmt::format("the flow rule alone makes {:.1f} % in FEM ({:.3f} as given, {:.3f} with ψ = φ), "
                      "and LEM has none",
                      100 * std::abs(a / b - 1), a, b));
  }
  if (points != nullptr && !points->is_extrapolated)
    reasons.push_back("the factor by MPM is that of one mesh, not extrapolated");
  const std::string apart = spread < far ? fmt::format("The methods lie within {:.1f} % of each other", 100 * spread)
                                         : fmt::format("The methods lie {:.0f} % apart", 100 * spread);
  return fmt::format("{}{}{}.", apart, reasons.empty() ? "" : "; ", fmt::join(reasons, "; "));
}

bool has_design_values(const results::RunResult& run) {
  return run.methods && run.methods->partial_factors;
}

}  // namespace talus::report
