// SPDX-License-Identifier: MIT
#include "drawing/ags.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "drawing/case_text.hpp"

namespace talus::drawing {
namespace {

constexpr std::uint64_t largest_ags = largest_file::table;

using Cells = std::vector<std::string>;

/// A row of a group, and the number of its line.
struct Row {
  Cells cells;
  int line = 0;
};

struct Group {
  std::string name;
  int line = 0;
  Row headings;
  std::vector<Row> rows;
};

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Splits a line at its commas. Quotation marks around a cell are removed, and doubled ones within it become one.
Cells split(std::string_view line) {
  Cells cells;
  for (bool is_open = true; is_open;) {
    line = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    std::string cell;
    if (line.starts_with('"')) {
      std::size_t i = 1;
      for (; i < line.size(); ++i) {
        if (line[i] == '"' && (++i == line.size() || line[i] != '"')) break;
        cell += line[i];
      }
      line.remove_prefix(std::min(i, line.size()));
    }
    const std::size_t end = std::min(line.find(','), line.size());
    cell += trim(line.substr(0, end));
    is_open = end < line.size();
    line.remove_prefix(std::min(end + 1, line.size()));
    cells.push_back(std::move(cell));
  }
  return cells;
}

/// Returns the name of the group that a line begins; empty if it begins none: "GROUP","GEOL" of AGS 4, "**GEOL" of
/// AGS 3.
std::string find_group(const Cells& cells) {
  if (cells.size() > 1 && cells[0] == "GROUP") return cells[1];
  if (!cells[0].starts_with("**")) return "";
  return cells[0].substr(cells[0].find_first_not_of("*?") == std::string::npos ? cells[0].size()
                                                                               : cells[0].find_first_not_of("*?"));
}

bool is_read(const std::string& group) {
  return group == "LOCA" || group == "HOLE" || group == "GEOL" || group == "ABBR" || group == "HORN";
}

/// Appends the cells of a line <CONT>, the first of which is that word, to those of the row before.
void continue_row(Cells& row, const Cells& more) {
  row.resize(std::max(row.size(), more.size()));
  for (std::size_t i = 1; i < more.size(); ++i) row[i] += more[i];
}

void add_line(Group& group, Cells cells, int line) {
  if (cells[0].starts_with('*')) {
    // Headings of AGS 3 continue on further lines.
    if (group.headings.cells.empty()) group.headings.line = line;
    for (std::string& cell : cells) {
      cell.erase(0, std::min(cell.find_first_not_of("*?"), cell.size()));
      group.headings.cells.push_back(std::move(cell));
    }
    // A comma at the end of a line of headings adds an empty cell, which its rows lack.
    if (group.headings.cells.back().empty()) group.headings.cells.pop_back();
    return;
  }
  if (cells[0] == "HEADING") {
    group.headings = {std::move(cells), line};
  } else if (cells[0] == "<CONT>" && !group.rows.empty()) {
    continue_row(group.rows.back().cells, cells);
  } else {
    group.rows.push_back({std::move(cells), line});
  }
}

/// More than the boreholes and layers of any site.
constexpr std::size_t most_cells = 4'000'000, most_groups = 100;

std::vector<Group> read_groups(const std::string& path) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_ags, text))
    fail_input("'{}' cannot be read: {}", path, fault->why);
  if (is_utf16(std::string_view(text).substr(0, text.find('\n'))))
    fail_input("'{}' is in UTF-16; save it as UTF-8", path);
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  std::vector<Group> groups;
  bool is_wanted = false, has_any = false;
  std::size_t cell_count = 0;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trim(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty()) continue;
    const bool may_begin = line.starts_with("\"GROUP\"") || line.starts_with("GROUP,") || line.starts_with("\"**") ||
                           line.starts_with("**");
    if (!may_begin && !is_wanted) continue;
    Cells cells = split(line);
    if ((cell_count += cells.size()) > most_cells || groups.size() > most_groups)
      fail_input("'{}' has more than {} cells, or {} groups of boreholes and layers", path, most_cells, most_groups);
    if (const std::string name = find_group(cells); may_begin && !name.empty()) {
      has_any = true;
      is_wanted = is_read(name);
      if (is_wanted) groups.push_back({name, number, {}, {}});
    } else if (is_wanted) {
      add_line(groups.back(), std::move(cells), number);
    }
  }
  if (!has_any) fail_input("'{}' has no groups of the AGS format, such as \"GROUP\",\"GEOL\"", path);
  return groups;
}

std::size_t find_column(const Group& group, std::string_view heading) {
  const auto& cells = group.headings.cells;
  return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), heading) - cells.begin());
}

/// Returns the descriptions of codes by heading and code. Long ones, which list what a code comprises, are no names,
/// and those of several codes would merge them.
std::map<std::pair<std::string, std::string>, std::string> read_codes(const std::vector<Group>& groups) {
  constexpr std::size_t longest = 40;
  std::map<std::pair<std::string, std::string>, std::string> codes;
  for (const Group& group : groups) {
    if (group.name != "ABBR") continue;
    const std::size_t heading = find_column(group, "ABBR_HDNG"), code = find_column(group, "ABBR_CODE"),
                      description = find_column(group, "ABBR_DESC");
    for (const Row& row : group.rows)
      if (std::max({heading, code, description}) < row.cells.size())
        if (const std::string& words = row.cells[description]; !words.empty() && words.size() <= longest)
          codes[{row.cells[heading], row.cells[code]}] = words;
  }
  std::map<std::pair<std::string, std::string>, int> uses;
  for (const auto& [code, words] : codes) ++uses[{code.first, words}];
  std::erase_if(codes, [&](const auto& entry) { return uses.at({entry.first.first, entry.second}) > 1; });
  return codes;
}

/// Throws Error (wrong_input) for a borehole that is inclined, as its depths are taken as vertical.
void check_vertical(const Group& group, const std::string& path) {
  constexpr double upright = 90, tolerance = 5;  // [°] from the horizontal
  for (const char* heading : {"HOLE_INCL", "HORN_INCL", "LOCA_INCL"}) {
    const std::size_t column = find_column(group, heading);
    for (const Row& row : group.rows) {
      if (column >= row.cells.size()) continue;
      const std::string& cell = row.cells[column];
      double angle = 0;
      if (parse_number(cell.data(), cell.data() + cell.size(), angle) != cell.data() + cell.size() || cell.empty())
        continue;
      if (std::abs(std::abs(angle) - upright) > tolerance)
        fail_input("{}:{}: borehole {} is inclined, {} = {:g}°; only vertical boreholes are read", path, row.line,
                   clean_text(row.cells[group.headings.cells.front() == "HEADING" ? 1 : 0]), heading, angle);
    }
  }
}

/// Appends a row of the table behind empty lines in place of those that have no row of their own.
void write_row(std::string& text, int& line, const Row& row) {
  for (; line < row.line; ++line) text += '\n';
  bool is_first = true;
  for (const std::string& cell : row.cells) {
    text += is_first ? "\"" : ",\"";
    is_first = false;
    for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += '"';
  }
}

}  // namespace

bool is_ags(const std::string& path) {
  return to_lower(path).ends_with(".ags");
}

std::vector<AgsGroup> read_ags(const std::string& path) {
  std::vector<Group> groups = read_groups(path);
  const auto codes = read_codes(groups);
  std::vector<AgsGroup> tables;
  bool has_places = false, has_layers = false;
  for (Group& group : groups) {
    check_vertical(group, path);
    if (group.name == "ABBR" || group.name == "HORN") continue;
    if (group.headings.cells.empty())
      fail_input("{}:{}: the group {} has no line of headings", path, group.line, group.name);
    for (const char* heading : {"GEOL_GEOL", "GEOL_LEG"}) {
      const std::size_t column = find_column(group, heading);
      for (Row& row : group.rows)
        if (column < row.cells.size())
          if (const auto found = codes.find({heading, row.cells[column]}); found != codes.end())
            row.cells[column] = found->second;
    }
    (group.name == "GEOL" ? has_layers : has_places) = true;
    AgsGroup table{group.name, "", group.headings.line};
    int line = table.first_line;
    write_row(table.text, line, group.headings);
    for (const Row& row : group.rows) write_row(table.text, line, row);
    tables.push_back(std::move(table));
  }
  if (!has_places) fail_input("'{}' has no group LOCA (AGS 3: HOLE) with the positions of boreholes", path);
  if (!has_layers) fail_input("'{}' has no group GEOL with the layers of boreholes", path);
  return tables;
}

}  // namespace talus::drawing
