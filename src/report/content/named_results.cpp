// SPDX-License-Identifier: MIT
#include "report/content/named_results.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "report/words/numbers.hpp"
#include "results/named.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Whether all points left the grid.
bool has_lost_all(const results::RunResult& run) {
  return run.budgets && run.budgets->lost.points > 0 && run.budgets->points <= 0;
}

/// Long times of a timeline are told in hours or days; volumes, flows and speeds in feet where lengths are.
ShownUnit choose_unit(const results::NamedResult& result, const ShownUnits& units, std::size_t dimension) {
  const std::string& name = result.unit.name;
  if (name == "s") return choose_time_unit(std::abs(result.value));
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
    const results::NamedValue about = known[result.name];  // nothing: another version knew other results
    // Of a strength reduction the runout is that of a trial.
    const bool of_run = folder.data.analysis == input::AnalysisKind::run;
    if (has_lost_all(folder.run) && about.kind == results::ResultKind::runout && of_run) continue;
    // Its title says so.
    const bool flows_in = about.quantity == "discharge" && result.value < 0;
    const ShownUnit unit = choose_unit(result, units, dimension);
    json& out = list.emplace_back();
    out = {{"name", result.name},
            {"title", flows_in ? result.title.substr(0, result.title.rfind(',')) : result.title},
            {"value", flows_in ? -result.value : result.value},
            {"unit", to_json(unit)},
            {"kind", results::to_word(about.kind)},
            {"quantity", about.quantity},
            {"by", about.by ? to_word(*about.by) : ""}};
    if (about.uncertainty)
      out["text"] = show_uncertain(result.value, about.uncertainty->value, {"", unit.si}) + "\u00a0" + unit.name;
  }
  return list;
}

}  // namespace talus::report
