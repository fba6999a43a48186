#include "report/content/named_results.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "input/case/method_names.hpp"
#include "input/case/result_names.hpp"

namespace talus::report {

using input::ResultKind;
using nlohmann::json;

namespace {

const char* to_word(ResultKind kind) {
  switch (kind) {
    case ResultKind::factor:
      return "factor";
    case ResultKind::yield_acceleration:
      return "yield_acceleration";
    case ResultKind::over_design:
      return "over_design";
    case ResultKind::runout:
      return "runout";
    case ResultKind::motion:
      return "motion";
    case ResultKind::stage:
      return "stage";
    case ResultKind::mesh:
      return "mesh";
    case ResultKind::water:
      return "water";
    case ResultKind::seepage:
      return "seepage";
    case ResultKind::other:
      return "other";
  }
  return "";
}

/// Whether all points left the grid.
bool has_lost_all(const results::RunResult& run) {
  return run.budgets && run.budgets->lost.points > 0 && run.budgets->points <= 0;
}

}  // namespace

json list_named_results(const ResultFolder& folder) {
  std::map<std::string, input::ResultName> names;
  for (const input::ResultName& name : input::list_result_names(folder.data)) names.emplace(name.name, name);
  json list = json::array();
  for (const results::NamedResult& result : folder.run.results) {
    // Another version may know other results.
    const auto known = names.find(result.name);
    const input::ResultName name =
        known != names.end() ? known->second : input::ResultName{"", "", "", ResultKind::other, "", {}};
    // Of a strength reduction the runout is that of a trial.
    const bool of_run = folder.data.analysis == input::AnalysisKind::run;
    if (has_lost_all(folder.run) && name.kind == ResultKind::runout && of_run) continue;
    list.push_back({{"name", result.name},
                    {"title", result.title},
                    {"value", result.value},
                    {"unit", {{"name", result.unit.name}, {"si", result.unit.si}}},
                    {"kind", to_word(name.kind)},
                    {"quantity", name.quantity},
                    {"by", name.by ? input::get_word(*name.by) : ""}});
  }
  return list;
}

}  // namespace talus::report
