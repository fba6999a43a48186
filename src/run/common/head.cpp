// SPDX-License-Identifier: MIT
#include "run/common/head.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>

#include "base/lane.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "input/case/compare.hpp"
#include "input/case/result_names.hpp"
#include "results/named.hpp"

namespace talus::run {

namespace {

std::string now_as_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string find_machine() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

results::Project make_project(const input::Case& data) {
  const input::Project& p = data.project;
  return {data.title, p.name, p.client, p.author, p.checked_by, p.revision, p.notes};
}

results::Provenance make_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  results::Provenance result;
  result.program = "talus";
  result.version = version;
  result.commit = commit;
  result.compiler = compiler;
  result.build_type = build_type;
  result.architecture = architecture;
  result.level = instruction_level;
  result.lane_width = lane_width;
  result.machine = find_machine();
  result.threads = threads;
  result.started = now_as_text();
  result.case_file = loaded.file;
  result.input_hash = input_hash;
  return result;
}

results::DisplayUnits make_display_units(const input::Output& output) {
  return {output.length_unit, output.displacement_unit, output.stress_unit};
}

results::RunResult begin_result(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  results::RunResult run;
  run.title = loaded.data.title;
  run.project = make_project(loaded.data);
  run.provenance = make_provenance(loaded, input_hash, threads);
  run.units = make_display_units(loaded.data.output);
  for (const mesh::Polygon& p : loaded.data.mesh.polygons) run.outlines.emplace_back(p.points.begin(), p.points.end());
  run.input = loaded.echo;
  return run;
}

std::string format_length(const results::RunResult& run, double metres, int digits) {
  return format_value(metres, read_units(run).length, digits);
}

namespace {

results::Unit find_unit(const std::string& unit, const input::Output& output) {
  const std::string shown = unit == "m" ? output.length_unit : (unit == "Pa" ? output.stress_unit : unit);
  return {shown, units::get_si_factor(shown)};
}

/// A computed value, with remarks on how it was obtained.
struct Found {
  std::optional<double> value;
  std::string note;
};

results::Comparison compare_with(const input::Case& data, const input::Compare& compare,
                                 const std::function<Found(const std::string&)>& find) {
  const auto result = input::find_result_name(data, compare.name);
  const auto known = result ? result : input::find_possible_name(data, compare.name);
  const std::string unit = compare.value.unit.empty() && known ? known->unit : compare.value.unit;
  const Found found = result ? find(compare.name) : Found{std::nullopt, "the case leaves this result out"};
  results::Comparison out;
  out.name = compare.name;
  out.title = known ? known->title : compare.name;
  out.unit = {unit, units::get_si_factor(unit)};
  out.computed = found.value;
  out.published = input::to_si(compare.value);
  out.tolerance = input::find_tolerance(compare);
  out.tolerance_text = compare.tolerance.text;
  out.source = compare.source;
  out.note = found.value || !found.note.empty() ? found.note : "the run did not reach this result";
  // A difference equal to the tolerance passes, regardless of rounding in the last digit.
  out.passes = found.value && std::abs(*found.value - out.published) <= out.tolerance * (1 + 1e-12);
  return out;
}

Found find_in_run(const results::RunResult& run, const std::string& name) {
  if (const auto factor = input::find_trial_factor(name)) {
    results::CurveValue at = results::find_displacement(run, *factor);
    return {at.displacement, std::move(at.note)};
  }
  const auto value = results::find_named(run, name);
  if (!value || value->is_determined()) return {value ? std::optional(value->value) : std::nullopt, ""};
  return {std::nullopt, results::explain_undetermined(*value)};
}

}  // namespace

std::optional<double> find_result(const results::RunResult& run, const std::string& name) {
  return find_in_run(run, name).value;
}

std::vector<results::NamedResult> list_results(const input::Case& data, const results::RunResult& run) {
  std::vector<results::NamedResult> list;
  for (const results::NamedValue& result : input::list_result_names(data)) {
    const Found found = find_in_run(run, result.name);
    if (!found.value && found.note.empty()) continue;
    const auto why = found.value ? std::nullopt : std::optional(found.note);
    list.push_back({result.name, result.title, found.value, find_unit(result.unit, data.output), why});
  }
  return list;
}

std::vector<results::Comparison> compare_results(const input::Case& data, const results::RunResult& run) {
  std::vector<results::Comparison> list;
  for (const input::Compare& compare : data.compare)
    if (!input::find_point_result_name(compare.name))
      list.push_back(compare_with(data, compare, [&](const std::string& name) { return find_in_run(run, name); }));
  return list;
}

std::vector<results::Comparison> compare_results(const input::Case& data, const results::PointTests& tests) {
  std::vector<results::Comparison> list;
  for (const input::Compare& compare : data.compare)
    if (input::find_point_result_name(compare.name))
      list.push_back(compare_with(data, compare, [&](const std::string& name) {
        const auto found = tests.point_results.find(name);
        return found == tests.point_results.end() ? Found{} : Found{found->second, ""};
      }));
  return list;
}

}  // namespace talus::run
