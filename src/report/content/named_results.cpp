// SPDX-License-Identifier: MIT
#include "report/content/named_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

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

/// What the mesh leaves open in a number of a runout that is told with it; nothing for other results. The inner
/// optional is empty where one mesh shows no uncertainty.
std::optional<std::optional<double>> find_uncertainty(const results::RunResult& run, const std::string& name) {
  static const std::map<std::string, std::optional<double> results::RunoutUncertainty::*> told{
      {"front_advance", &results::RunoutUncertainty::front_advance},
      {"toe_distance", &results::RunoutUncertainty::toe_distance},
      {"crest_retreat", &results::RunoutUncertainty::crest_retreat},
      {"moved_volume", &results::RunoutUncertainty::moved_volume}};
  const auto find = [&](const results::Runout& runout,
                        const std::string& prefix) -> std::optional<std::optional<double>> {
    if (!name.starts_with(prefix)) return std::nullopt;
    const auto found = told.find(name.substr(prefix.size()));
    if (found == told.end()) return std::nullopt;
    return results::RunoutUncertainty(runout).*found->second;
  };
  if (run.runout)
    if (const auto found = find(*run.runout, "runout.")) return found;
  if (run.runouts)
    for (const results::RunoutTrial& r : *run.runouts)
      if (const auto found = find(r.runout, fmt::format("runout[{:g}].", r.trial.factor))) return found;
  return std::nullopt;
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
    json& told = list.emplace_back();
    told = {{"name", result.name},
            {"title", flows_in ? result.title.substr(0, result.title.rfind(',')) : result.title},
            {"value", flows_in ? -result.value : result.value},
            {"unit", to_json(unit)},
            {"kind", results::to_word(about.kind)},
            {"quantity", about.quantity},
            {"by", about.by ? to_word(*about.by) : ""}};
    if (const auto uncertainty = find_uncertainty(folder.run, result.name))
      told["text"] = show_uncertain(result.value, *uncertainty, {"", unit.si}) + "\u00a0" + unit.name;
  }
  return list;
}

}  // namespace talus::report
