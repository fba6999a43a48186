// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "output/files/history.hpp"
#include "report/content/fields.hpp"
#include "report/content/sequence.hpp"
#include "report/folder/numbers.hpp"
#include "run/mpm/record/motion.hpp"

namespace talus::report {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Returns true for the columns of a section table that are coordinates, not fields.
bool is_place(const std::string& name) {
  return name == "time" || name == "distance" || name == "x" || name == "y" || name == "z" || name == "points";
}

/// Limit on the rows of a history in the report of a study, sufficient for a curve over the width of the page.
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

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Returns a title such as "crest: displacement x" for "crest.displacement_x". Names of monitors are not changed.
std::string make_column_title(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  std::string quantity = dot == std::string::npos ? name : name.substr(dot + 1);
  std::replace(quantity.begin(), quantity.end(), '_', ' ');
  return dot == std::string::npos ? quantity : name.substr(0, dot) + ": " + quantity;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Makes a column of a history or of the ground profile.
json make_column(const output::Column& column, bool ground, const std::vector<double>& values,
                 const std::vector<std::size_t>& rows) {
  const output::HistoryColumn described =
      ground ? output::HistoryColumn{.quantity = output::HistoryQuantity::position, .part = {}, .of = ""}
             : output::describe_column(column.name);
  json list = json::array();
  for (const std::size_t i : rows) list.push_back(std::isfinite(values[i]) ? json(values[i]) : json());
  json made{{"name", column.name},
            {"title", make_column_title(column.name)},
            {"unit", column.unit},
            {"quantity", results::to_word(described.quantity)},
            {"of", described.of},
            {"largest", described.largest},
            {"extensive", described.extensive},
            {"values", list}};
  if (described.part) made["part"] = results::to_word(*described.part);
  if (described.component != 0) made["component"] = std::string(1, described.component);
  return made;
}

/// Reads "x [m],ground before [m],ground after [m]"; cells are empty where there is no ground, unlike in a history.
output::HistoryTable read_profile(const fs::path& path) {
  output::HistoryTable table;
  std::istringstream file(read_user_file(path, largest_file::result));
  std::string line;
  std::getline(file, line);
  for (const std::string& title : split(line)) {
    const std::size_t open = title.rfind(" [");
    table.columns.push_back(
        open == std::string::npos
            ? output::Column{title, ""}
            : output::Column{title.substr(0, open), title.substr(open + 2, title.size() - open - 3)});
  }
  table.values.resize(table.columns.size());
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = split(line);
    for (std::size_t k = 0; k < table.values.size(); ++k) {
      double value = std::numeric_limits<double>::quiet_NaN();
      if (k < cells.size()) std::from_chars(cells[k].data(), cells[k].data() + cells[k].size(), value);
      table.values[k].push_back(value);
    }
  }
  return table;
}

/// Converts profile.csv, which is always in metres, to the unit of display.
void show_in(const ShownUnit& length, output::HistoryTable& table) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    if (table.columns[k].unit != "m") continue;
    table.columns[k].unit = length.name;
    for (double& value : table.values[k]) value /= length.si;
  }
}

class TableList {
 public:
  TableList(const ShownUnit& length, json& warnings) : length_(length), warnings_(warnings) {}

  /// Adds the three tables of `folder` that belong to the time axis of a sequence of frames.
  void add(const fs::path& folder, const std::string& sequence, const std::string& suffix, const std::string& history,
           const std::string& monitors, const std::string& ground) {
    sequence_ = sequence;
    add(folder / "history.csv", "history" + suffix, history, "history");
    add(folder / "monitors.csv", "monitors" + suffix, monitors, "monitors");
    add(folder / "profile.csv", "profile" + suffix, ground, "ground");
  }

  json tables = json::array();

 private:
  void add(const fs::path& path, const std::string& id, const std::string& title, const std::string& kind) {
    if (!fs::exists(path) || fs::file_size(path) == 0) return;
    try {
      output::HistoryTable table = kind == "ground" ? read_profile(path) : output::read_history(path);
      if (kind == "ground") show_in(length_, table);
      add(table, id, title, kind);
    } catch (const Error& error) {
      warnings_.push_back(fmt::format("{} is not shown: {}", title, error.what()));
    }
  }

  void add(const output::HistoryTable& table, const std::string& id, const std::string& title,
           const std::string& kind) {
    if (table.columns.empty() || table.values[0].empty()) return;
    const std::size_t count = table.values[0].size();
    const std::vector<std::size_t> rows = choose_frames(count, most_rows);
    json columns = json::array();
    for (std::size_t k = 1; k < table.columns.size(); ++k)
      columns.push_back(make_column(table.columns[k], kind == "ground", table.values[k], rows));
    tables.push_back(
        {{"id", id},
         {"title", rows.size() == count ? title : fmt::format("{} ({} of {} rows)", title, rows.size(), count)},
         {"kind", kind},
         {"sequence", sequence_},
         {"x", make_column(table.columns[0], kind == "ground", table.values[0], rows)},
         {"columns", columns}});
  }

  ShownUnit length_;
  std::string sequence_;
  json& warnings_;
};

}  // namespace

json make_tables(const ResultFolder& folder, json& warnings) {
  TableList list(read_units(folder.run).length, warnings);
  list.add(folder.path, "stages", "", "History of the stages", "Monitors during the stages", "Ground before and after");
  for (const TrialFolder& trial : folder.trials) {
    if (!trial.runs_out) continue;
    const std::string name = fmt::format("runout_{:g}", trial.factor),
                      words = fmt::format("runout at SRF {:g}", trial.factor);
    list.add(trial.path, name, "_" + name, "History of the " + words, "Monitors during the " + words,
             "Ground before and after the " + words);
  }
  return list.tables;
}

}  // namespace talus::report
