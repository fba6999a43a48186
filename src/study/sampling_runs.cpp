// SPDX-License-Identifier: MIT
// Samples calculated by runs of the case: finite elements, material points with their runout, or slices in time.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "input/echo.hpp"
#include "run/named_results.hpp"
#include "run/run_case.hpp"
#include "study/sampling.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The first of the names under which a run tells a number.
std::string find_name(const std::vector<StudyRow>& rows, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const StudyRow& row : rows)
      if (row.result && run::find_result(*row.result, name)) return name;
  return "";
}

/// Names of the factor by a method, the first one before the others.
std::vector<std::string> list_factors(Method method) {
  if (method == Method::lem) return {"timeline.least"};
  if (method == Method::fem) return {"fem.factor", "fem.associated.factor"};
  return {"factor_of_safety.frozen", "factor_of_safety.bilinear", "factor_of_safety.displacement"};
}

/// That number of every sample; the first row is the case at the means.
std::vector<double> take(const std::vector<StudyRow>& rows, const std::string& name) {
  std::vector<double> values;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool ended = rows[i].summary.status == results::VariantStatus::finished && rows[i].result;
    values.push_back(ended ? run::find_result(*rows[i].result, name).value_or(none) : none);
  }
  return values;
}

/// When the factor of each sample is first found below the target [s].
std::vector<double> take_failure_times(const std::vector<StudyRow>& rows) {
  std::vector<double> times;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    times.push_back(none);
    if (rows[i].summary.status != results::VariantStatus::finished || !rows[i].result || !rows[i].result->timeline)
      continue;
    const results::Timeline& timeline = *rows[i].result->timeline;
    if (timeline.fails_from_start) times.back() = 0;
    if (timeline.failure) times.back() = timeline.failure->to;
  }
  return times;
}

}  // namespace

StudyPlan plan_samples(const input::LoadedCase& base, const std::vector<input::Override>& given, const SampleSet& set) {
  std::vector<input::Override> overrides = given;
  overrides.push_back({"analysis.methods", fmt::format(R"(["{}"])", results::to_word(set.summary.method))});
  // Samples scatter by more than the mesh does, and each of them would be run on two.
  if (set.summary.method == Method::mpm) overrides.push_back({"output.runout_meshes", "1"});
  StudyPlan plan;
  plan.summary = begin_study(base);
  for (const results::UncertainNumber& n : set.sampled.numbers) {
    plan.summary.vary.push_back({n.key, n.unit, {}});
    plan.names.push_back(n.name);
  }
  const std::size_t digits = std::to_string(set.size()).size();
  const auto add = [&](const std::string& name, const std::string& label, const std::vector<double>& values) {
    Variant variant;
    variant.name = name;
    variant.label = label;
    for (const double value : values) variant.values.push_back(fmt::format("{:.6g}", value));
    try {
      variant.changes = set_values(overrides, set.sampled, values);
      variant.loaded = input::read_case_text(base.text, base.file, variant.changes);
    } catch (const InputError& error) {
      throw refuse_sample(label, error);
    }
    variant.input_hash = input::hash_input(variant.loaded.echo);
    plan.variants.push_back(std::move(variant));
  };
  add("means", "at the means", set.sampled.means);
  for (std::size_t i = 0; i < set.size(); ++i)
    add(fmt::format("sample_{:0{}}", i + 1, digits), fmt::format("sample {}", i + 1), set.get_sample(i));
  return plan;
}

results::StudyResult make_runs_result(const input::LoadedCase& base, const StudyPlan& plan, const std::vector<StudyRow>& rows,
                               double seconds, SampleSet& set) {
  const Method method = set.summary.method;
  const std::string factor = find_name(rows, list_factors(method));
  if (!factor.empty()) set.factor = take(rows, factor);
  if (method == Method::lem) set.failure_time = take_failure_times(rows);
  if (method == Method::mpm) {
    std::vector<std::string> names{"runout.toe_distance"};
    for (const double f : base.data.strength_reduction.curve.runout)
      names.push_back(fmt::format("runout[{:g}].toe_distance", f));
    if (const std::string name = find_name(rows, names); !name.empty()) {
      set.runout = take(rows, name);
      set.summary.runout.emplace().name = name;
    }
  }
  set.summary.method_title = method == Method::fem   ? "Finite elements"
                          : method == Method::lem ? "Slices, the least factor in time"
                                                  : "Material points";
  set.summary.method_title += ", a run for every sample" + (factor.empty() ? "" : ", " + factor);
  if (set.factor.empty() && set.runout.empty())
    set.summary.notes.push_back("No run has come to a factor of safety or a runout.");
  set.summary.seconds = seconds;
  return describe_study(plan, rows);
}

}  // namespace talus::study
