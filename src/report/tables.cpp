#include "report/tables.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "output/history.hpp"
#include "report/thinning.hpp"

namespace talus::report {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// "crest.displacement_x" → "crest: displacement x".
std::string to_title(const std::string& name) {
  std::string title;
  for (const char c : name) {
    if (c == '.')
      title += ": ";
    else
      title += c == '_' ? ' ' : c;
  }
  return title;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

json make_column(const output::Column& column, const std::vector<double>& values,
                 const std::vector<std::size_t>& rows) {
  json list = json::array();
  for (const std::size_t i : rows) list.push_back(std::isfinite(values[i]) ? json(values[i]) : json());
  return {{"name", column.name}, {"title", to_title(column.name)}, {"unit", column.unit}, {"values", list}};
}

/// "x [m],ground before [m],ground after [m]": unlike a history it has empty cells, where there is no ground.
output::HistoryTable read_profile(const fs::path& path) {
  output::HistoryTable table;
  std::ifstream file(path);
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

void add_table(json& tables, const fs::path& path, const std::string& id, const std::string& title,
               const std::string& kind) {
  if (!fs::exists(path) || fs::file_size(path) == 0) return;
  const output::HistoryTable table = kind == "ground" ? read_profile(path) : output::read_history(path);
  if (table.columns.empty() || table.values[0].empty()) return;
  const std::size_t count = table.values[0].size();
  const std::vector<std::size_t> rows = choose_frames(count, most_rows);
  json columns = json::array();
  for (std::size_t k = 1; k < table.columns.size(); ++k)
    columns.push_back(make_column(table.columns[k], table.values[k], rows));
  tables.push_back(
      {{"id", id},
       {"title", rows.size() == count ? title : fmt::format("{} ({} of {} rows)", title, rows.size(), count)},
       {"kind", kind},
       {"x", make_column(table.columns[0], table.values[0], rows)},
       {"columns", columns}});
}

}  // namespace

json make_tables(const ResultFolder& folder) {
  json tables = json::array();
  add_table(tables, folder.path / "history.csv", "history", "History of the stages", "history");
  add_table(tables, folder.path / "monitors.csv", "monitors", "Monitors during the stages", "monitors");
  add_table(tables, folder.path / "profile.csv", "profile", "Ground before and after", "ground");
  for (const TrialFolder& trial : folder.trials) {
    if (!trial.runs_out) continue;
    const std::string name = fmt::format("runout_{:g}", trial.factor),
                      words = fmt::format("runout at SRF {:g}", trial.factor);
    add_table(tables, trial.path / "history.csv", "history_" + name, "History of the " + words, "history");
    add_table(tables, trial.path / "monitors.csv", "monitors_" + name, "Monitors during the " + words, "monitors");
    add_table(tables, trial.path / "profile.csv", "profile_" + name, "Ground before and after the " + words, "ground");
  }
  return tables;
}

}  // namespace talus::report
