// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "report/content/sequence.hpp"
#include "report/folder/numbers.hpp"
#include "results/named.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// More times than this cannot be distinguished in one diagram.
constexpr std::size_t most_times = 5;

std::size_t find_nearest(const std::vector<double>& times, double time) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (std::abs(times[i] - time) <= std::abs(times[nearest] - time)) nearest = i;
  return nearest;
}

}  // namespace

bool has_lost_all(const results::RunResult& run) {
  return run.budgets && run.budgets->lost.points > 0 && run.budgets->points <= 0;
}

std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock) {
  std::vector<std::size_t> shown;
  if (times.empty()) return shown;
  if (clock.shown_times.empty()) {
    const std::size_t first = find_nearest(times, clock.start);
    for (const std::size_t i : choose_frames(times.size() - first, most_times)) shown.push_back(first + i);
  }
  for (const double time : clock.shown_times) shown.push_back(find_nearest(times, clock.start + time));
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  return shown;
}

using nlohmann::json;

namespace {

/// Times of a timeline are shown in hours or days; volumes, flows and speeds in feet if lengths are.
ShownUnit choose_unit(const results::NamedResult& result, const ShownUnits& units, std::size_t dimension) {
  const std::string& name = result.unit.name;
  if (name == "s") return choose_time_unit(std::abs(result.value.value_or(0)));
  if (name == "m") return units.length;
  if (name == "m/s") return units.speed();
  if (name.starts_with("m3/s")) return units.flow(dimension);
  if (name.starts_with("m3")) return units.volume(dimension);
  return {name, result.unit.si};
}

}  // namespace

json list_named_results(const ResultFolder& folder) {
  std::map<std::string, results::NamedValue> known;
  for (const results::NamedValue& value : results::list_values(folder.run, folder.data.mesh.dimension))
    known.emplace(value.name, value);
  const ShownUnits units = read_units(folder.run);
  const std::size_t dimension = get_dimension(folder.run);
  json list = json::array();
  for (const results::NamedResult& result : folder.run.results) {
    const results::NamedValue about = known[result.name];  // empty for a result of another version
    // The runout of a strength reduction belongs to a trial.
    const bool of_run = folder.data.analysis == input::AnalysisKind::run;
    if (has_lost_all(folder.run) && about.kind == results::ResultKind::runout && of_run) continue;
    // The title already states that the discharge is an inflow.
    const bool flows_in = about.quantity == "discharge" && result.value.value_or(0) < 0;
    const ShownUnit unit = choose_unit(result, units, dimension);
    json& out = list.emplace_back();
    out = {{"name", result.name},
           {"title", flows_in ? result.title.substr(0, result.title.rfind(',')) : result.title},
           {"value", nullptr},
           {"unit", report::to_json(unit)},
           {"kind", results::to_word(about.kind)},
           {"quantity", about.quantity},
           {"by", about.by ? to_word(*about.by) : ""}};
    if (result.value && about.is_determined()) out["value"] = flows_in ? -*result.value : *result.value;
    if (about.estimate && about.is_determined())
      out["text"] = format_uncertain(result.value.value_or(about.value), about.estimate->uncertainty(), {"", unit.si}) +
                    "\u00a0" + unit.name;
    else if (about.estimate)
      out["text"] = results::format_estimate(*about.estimate, unit);
  }
  return list;
}

}  // namespace talus::report
