#include "report/content/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "output/files/history.hpp"
#include "report/content/clock.hpp"
#include "report/content/fields.hpp"
#include "report/content/thinning.hpp"
#include "report/look_up.hpp"
#include "run/mpm/record/motion.hpp"

namespace talus::report {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Columns of a section's table that are no fields.
bool is_place(const std::string& name) {
  return name == "time" || name == "distance" || name == "x" || name == "y" || name == "z" || name == "points";
}

/// Rows of a history in the report of a study: enough for a curve as wide as the page.
constexpr std::size_t most_path_rows = 400;

json to_json(double value) {
  return std::isfinite(value) ? json(value) : json();
}

json make_section(const json& described, const output::HistoryTable& table, const Clock& clock, const json& summary) {
  const ShownUnits units = read_units(summary);
  json fields = json::array(), profiles = json::array();
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (is_place(table.columns[c].name)) continue;
    columns.push_back(c);
    const ScalarField scalar = find_scalar(table.columns[c].name, table.columns[c].unit, get_dimension(summary), units);
    fields.push_back({{"name", scalar.name}, {"title", scalar.title}, {"unit", report::to_json(scalar.unit)}});
  }
  const std::vector<double>& rows = table.values[0];
  std::vector<double> times;
  for (const double t : rows)
    if (times.empty() || times.back() != t) times.push_back(t);
  for (const std::size_t k : choose_shown(times, clock)) {
    json distance = json::array(), values = json::array();
    for (std::size_t c = 0; c < columns.size(); ++c) values.push_back(json::array());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] != times[k]) continue;
      distance.push_back(table.values[1][i]);
      for (std::size_t c = 0; c < columns.size(); ++c) values[c].push_back(to_json(table.values[columns[c]][i]));
    }
    profiles.push_back({{"time", times[k] - clock.start}, {"distance", distance}, {"values", values}});
  }
  return {{"name", get_text(described, {"name"})},
          {"from", find_list(described, {"from"})},
          {"to", find_list(described, {"to"})},
          {"width", get_number(described, {"width"})},
          {"fields", fields},
          {"profiles", profiles}};
}

}  // namespace

json make_sections(const fs::path& folder, const json& summary, json& warnings) {
  json sections = json::array();
  const std::optional<Clock> clock = read_clock(summary);
  if (!clock) return sections;
  for (const json& described : find_list(summary, {"sections"})) {
    const std::string name = get_text(described, {"name"});
    try {
      const output::HistoryTable table = output::read_history(folder / "sections" / (name + ".csv"));
      if (table.columns.size() > 2 && !table.values[0].empty())
        sections.push_back(make_section(described, table, *clock, summary));
    } catch (const Error& error) {
      warnings.push_back(fmt::format("Section '{}' is not shown: {}", name, error.what()));
    }
  }
  return sections;
}

json take_motion(const json& motion) {
  return {{"stage", get_text(motion, {"stage"})},
          {"start", get_number(motion, {"start"})},
          {"threshold", get_number(motion, {"threshold"})},
          {"monitors", find_list(motion, {"monitors"})},
          {"pattern", get_text(motion, {"pattern"}, "none")},
          {"sentence", get_text(motion, {"sentence"})}};
}

json make_paths(const fs::path& folder, const json& summary, json& warnings) {
  const std::optional<Clock> clock = read_clock(summary);
  const json* motion = find(summary, {"motion"});
  if (!clock || motion == nullptr || !fs::exists(folder / "monitors.csv")) return {};
  try {
    const output::HistoryTable table = output::read_history(folder / "monitors.csv");
    json times = json::array(), paths = json::array();
    for (const json& monitor : find_list(*motion, {"monitors"})) {
      const std::string name = get_text(monitor, {"name"});
      const run::MonitorPath path = run::read_monitor_path(table, name, {clock->stage, clock->start, clock->resets});
      json displacement = json::array();
      const bool is_first = times.empty();
      for (const std::size_t i : choose_frames(path.time.size(), most_path_rows)) {
        if (is_first) times.push_back(path.time[i]);
        displacement.push_back(to_json(path.displacement[i]));
      }
      paths.push_back({{"name", name}, {"displacement", displacement}});
    }
    return {{"time", times}, {"paths", paths}};
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The monitors are not shown: {}", error.what()));
    return {};
  }
}

}  // namespace talus::report
