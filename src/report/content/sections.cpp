// SPDX-License-Identifier: MIT
#include "report/content/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/file_name.hpp"
#include "output/files/history.hpp"
#include "report/content/clock.hpp"
#include "report/content/fields.hpp"
#include "report/content/thinning.hpp"
#include "report/words/numbers.hpp"
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

json make_section(const results::SectionLine& line, const output::HistoryTable& table, const results::RunResult& run) {
  const ShownUnits units = read_units(run);
  const results::Clock& clock = *run.clock;
  json fields = json::array(), profiles = json::array();
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (is_place(table.columns[c].name)) continue;
    columns.push_back(c);
    const ScalarField scalar = find_scalar(table.columns[c].name, table.columns[c].unit, get_dimension(run), units);
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
  return {{"name", line.name},   {"from", line.from}, {"to", line.to},
          {"width", line.width}, {"fields", fields},  {"profiles", profiles}};
}

}  // namespace

json make_sections(const ResultFolder& folder, json& warnings) {
  json sections = json::array();
  if (!folder.run.clock || !folder.run.sections) return sections;
  for (const results::SectionLine& line : *folder.run.sections) {
    try {
      const output::HistoryTable table =
          output::read_history(join_name(folder.path / "sections", make_printable(line.name), ".csv"));
      if (table.columns.size() > 2 && !table.values[0].empty())
        sections.push_back(make_section(line, table, folder.run));
    } catch (const Error& error) {
      warnings.push_back(fmt::format("Section '{}' is not shown: {}", line.name, error.what()));
    }
  }
  return sections;
}

json make_paths(const ResultFolder& folder, json& warnings) {
  const auto& clock = folder.run.clock;
  const auto& motion = folder.run.motion;
  if (!clock || !motion || !fs::exists(folder.path / "monitors.csv")) return {};
  try {
    const output::HistoryTable table = output::read_history(folder.path / "monitors.csv");
    json times = json::array(), paths = json::array();
    for (const results::MonitorMotion& monitor : motion->monitors) {
      const run::MonitorPath path = run::read_monitor_path(table, monitor.name, *clock);
      json displacement = json::array();
      const bool is_first = times.empty();
      for (const std::size_t i : choose_frames(path.time.size(), most_path_rows)) {
        if (is_first) times.push_back(path.time[i]);
        displacement.push_back(to_json(path.displacement[i]));
      }
      paths.push_back({{"name", monitor.name}, {"displacement", displacement}});
    }
    return {{"time", times}, {"paths", paths}};
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The monitors are not shown: {}", error.what()));
    return {};
  }
}

}  // namespace talus::report
