// SPDX-License-Identifier: MIT
#include "drawing/survey_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "drawing/ags.hpp"
#include "drawing/case_text.hpp"
#include "input/case/series_file.hpp"

namespace talus::drawing {
namespace {

constexpr std::size_t most_rows = 200'000;
constexpr std::uint64_t largest_table = 20 * largest_file::megabyte;
constexpr std::size_t most_columns = 200, most_depth_columns = 100;

/// The first line of a table, below its preamble.
struct Start {
  std::size_t at = 0;        ///< in the text
  int line = 1;              ///< its number
  std::size_t preamble = 0;  ///< number of lines with text above it
  std::string unit;          ///< unit of length that the preamble names
};

/// Returns the unit of length that a line such as "Unit: ft" names; empty if it names none.
std::string find_preamble_unit(std::string_view line) {
  const std::size_t mark = line.find_first_of(":=,;\t");
  if (mark == std::string_view::npos) return "";
  const std::string key = find_key(line.substr(0, mark));
  if (key != "unit" && key != "units" && key != "lengthunit" && key != "lengthunits") return "";
  const std::size_t begin = line.find_first_not_of(" \t:=,;", mark);
  if (begin == std::string_view::npos) return "";
  return find_length_unit(line.substr(begin, line.find_first_of(",;\t\r", begin) - begin));
}

/// Returns true for words between blanks above a line with another number of cells.
bool is_sentence(std::string_view line, std::string_view below) {
  if (line.find_first_of(",;\t") != std::string_view::npos) return false;
  below = below.substr(std::min(below.find_first_not_of(" \t\r\n"), below.size()));
  const std::string_view next = below.substr(0, below.find('\n'));
  const auto count = [](std::string_view words) { return input::TextTable("", std::string(words), 1).header().size(); };
  return !next.empty() && count(line) != count(next);
}

/// Searches the first lines for headings that are known. Without such a line, the table begins with the text.
Start find_start(std::string_view text) {
  constexpr std::size_t most_preamble = 60, longest = 10'000;
  Start start;
  std::size_t at = 0;
  for (int number = 1; at < text.size() && start.preamble < most_preamble; ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (line.size() > longest) break;
    if (const input::TextTable candidate("", std::string(line), 1); !candidate.header().empty()) {
      if (are_known(candidate.header()) && !is_sentence(line, text.substr(std::min(end + 1, text.size())))) {
        start.at = at, start.line = number;
        return start;
      }
      ++start.preamble;
      if (const std::string unit = find_preamble_unit(line); !unit.empty()) start.unit = unit;
    }
    at = end + 1;
  }
  return {};
}

/// Converts text that is not UTF-8, as programs of Windows write it, from Latin-1. Returns true if it was converted.
bool make_utf8(std::string& text) {
  if (!find_wrong_utf8(text)) return false;
  std::string converted;
  converted.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      converted += c;
    } else {
      converted += static_cast<char>(0xC0 | (byte >> 6));
      converted += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  text = std::move(converted);
  return true;
}

const char* name_form(TableForm form) {
  switch (form) {
    case TableForm::lines:
      return "lines";
    case TableForm::layers:
      return "boreholes, with a row for each layer";
    case TableForm::holes:
      return "boreholes, with a row for each and a column for each boundary";
    default:
      return "positions of boreholes";
  }
}

}  // namespace

SurveyTable::SurveyTable(const std::string& path, double unit) : text_(open(path, unit)) {
  read(unit);
}

SurveyTable::SurveyTable(input::TextTable text, const std::string& name, double unit)
    : part_(name), text_(std::move(text)) {
  read(unit);
}

input::TextTable SurveyTable::open(const std::string& path, double& unit) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_table, text))
    fail_input("the table '{}' cannot be read: {}", path, fault->why);
  if (is_utf16(std::string_view(text).substr(0, text.find('\n'))))
    fail_input("'{}' is in UTF-16; save it as UTF-8", path);
  is_converted_ = make_utf8(text);
  const Start start = find_start(text);
  preamble_ = start.preamble;
  if (!start.unit.empty()) {
    unit = units::parse_as_si("1 " + start.unit, "m", "the unit of the table");
    preamble_unit_ = start.unit;
  }
  return {path, text.substr(start.at), start.line};
}

void SurveyTable::read(double unit) {
  const std::string& path = text_.file();
  if (text_.header().empty()) fail_input("the table '{}' is empty", path);
  if (text_.rows() > most_rows)
    fail_input("the table '{}' has {} rows; at most {} are read", path, text_.rows(), most_rows);
  if (text_.header().size() > most_columns)
    fail_input("the table '{}' has {} columns; a survey has at most {}", path, text_.header().size(), most_columns);
  select_columns(unit);
  find_form();
  read_units_row();
  if (first_row_ >= text_.rows()) fail_input("the table '{}' has a header and no rows", path);
}

double SurveyTable::get_factor(const Heading& heading, double unit) const {
  if (heading.unit.empty()) return unit;
  return units::parse_as_si("1 " + heading.unit, "m", fmt::format("column '{}' of '{}'", heading.name, text_.file()));
}

void SurveyTable::take_column(Role role, std::span<const char* const> names, double unit) {
  for (const char* name : names) {
    const auto found =
        std::find_if(headings_.begin(), headings_.end(), [&](const Heading& h) { return h.key == name; });
    const auto i = static_cast<std::size_t>(found - headings_.begin());
    if (i == headings_.size() || is_used_[i]) continue;
    const bool is_text = role == Role::hole || role == Role::soil;
    if (!is_text && !is_numeric(i)) continue;
    if (role == Role::soil && !has_text(i)) continue;
    is_used_[i] = 1;
    const bool is_length = !is_text && role != Role::order;
    columns_[static_cast<std::size_t>(role)] =
        Column{i, is_length ? get_factor(*found, unit) : 0, !found->unit.empty() || !preamble_unit_.empty()};
    return;
  }
}

void SurveyTable::take_coordinates(double unit) {
  const auto is_there = [&](const char* name) {
    const auto found =
        std::find_if(headings_.begin(), headings_.end(), [&](const Heading& h) { return h.key == name; });
    return found != headings_.end() && is_numeric(static_cast<std::size_t>(found - headings_.begin()));
  };
  for (const auto& [x, northing] : get_coordinate_pairs()) {
    if (!is_there(x) || !is_there(northing)) continue;
    take_column(Role::x, {{x}}, unit);
    take_column(Role::northing, {{northing}}, unit);
    return;
  }
}

void SurveyTable::select_columns(double unit) {
  const std::size_t count = text_.header().size();
  is_used_.resize(count);
  for (const auto& heading : text_.header()) headings_.push_back(read_heading(heading));
  const bool is_headless = count >= 2 && headings_[0].name == "1" && headings_[1].name == "2";
  if (is_headless) {
    if (count > 3)
      fail_input("'{}' has {} columns without headings; name them in a first line, for example x, y, z", text_.file(),
                 count);
    columns_[static_cast<std::size_t>(Role::x)] = Column{0, unit, false};
    if (count == 3) columns_[static_cast<std::size_t>(Role::northing)] = Column{1, unit, false};
    columns_[static_cast<std::size_t>(Role::elevation)] = Column{count - 1, unit, false};
    return;
  }
  take_coordinates(unit);
  const bool is_plan = has(Role::northing);
  for (const Headings& of : get_known_headings()) {
    if (has(of.role)) continue;
    std::vector<const char*> names(of.names);
    // Beside coordinates an offset is the distance from the section, not along it.
    if (of.role == Role::chainage && is_plan)
      std::erase_if(names, [](const char* n) { return n == std::string_view("offset"); });
    take_column(of.role, names, unit);
  }
  // In a table with x and y only, y is the elevation.
  auto &elevation = columns_[static_cast<std::size_t>(Role::elevation)],
       &northing = columns_[static_cast<std::size_t>(Role::northing)];
  if (!elevation && is_headed(Role::northing, {"y"})) std::swap(elevation, northing);
  const bool is_pair = northing || (is_headed(Role::x, {"x"}) && is_headed(Role::elevation, {"y"}));
  has_both_positions_ = has(Role::chainage) && has(Role::x) && is_pair;
  take_depths(unit);
}

void SurveyTable::take_depths(double unit) {
  for (const Role role : {Role::x, Role::northing})
    if (has(Role::chainage) && has(role) && !has_both_positions_) unused_.push_back(get_heading(role));
  for (std::size_t i = 0; i < headings_.size(); ++i) {
    if (is_used_[i]) continue;
    const Heading& heading = headings_[i];
    const bool has_unit = !heading.unit.empty() || !preamble_unit_.empty();
    const bool is_length = is_numeric(i) && !is_latitude(heading.key) && !is_longitude(heading.key);
    // "depth" is that of a layer where rows are layers, and of the borehole otherwise.
    if (heading.key == "depth" && is_length) {
      const Role role = has(Role::soil) ? Role::bottom : Role::end;
      if (!has(role)) {
        columns_[static_cast<std::size_t>(role)] = Column{i, get_factor(heading, unit), has_unit};
        continue;
      }
    }
    // A part of a file, such as a group of AGS, has one meaning for each column.
    const bool may_be_depth = part_.empty() && has(Role::hole) && !has(Role::soil) && is_length &&
                              !heading.name.empty() && heading.key != "offset";
    if (may_be_depth && depths_.size() < most_depth_columns)
      depths_.push_back({heading.name, i, get_factor(heading, unit), has_unit});
    else
      unused_.push_back(heading.name);
  }
}

bool SurveyTable::is_headed(Role role, const std::vector<std::string>& keys) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column && std::find(keys.begin(), keys.end(), headings_[column->number].key) != keys.end();
}

void SurveyTable::find_form() {
  // A column "no" or "id" may number the points of a line, whose further columns are no depths.
  const bool has_holes =
      has(Role::hole) &&
      (!has(Role::elevation) || !is_headed(Role::hole, {"id", "no", "nr", "name", "pointid", "punkt"}) ||
       !is_headed(Role::elevation, {"z", "y", "elevation", "elev", "height", "höhe", "hoehe", "cote"}));
  const bool has_depth = has(Role::bottom) || has(Role::bottom_level) || has(Role::thickness) || has(Role::top);
  if (has(Role::soil) && has(Role::hole) && has_depth) {
    form_ = TableForm::layers;
  } else if (has_holes && has_position() && !has(Role::soil) && !depths_.empty()) {
    form_ = TableForm::holes;
  } else if (has(Role::hole) && has_position() && !has(Role::soil) && (has(Role::end) || has(Role::northing))) {
    form_ = TableForm::collars;
  } else if (has_position() && has(Role::elevation)) {
    form_ = TableForm::lines;
  } else {
    refuse_headings();
    std::string list;
    for (const auto& heading : text_.header()) list += fmt::format("{}'{}'", list.empty() ? "" : ", ", heading.name);
    if (list.size() > 200) list = list.substr(0, 200) + " …";
    fail_input(
        "the headings of '{}' are neither those of a line (x, station, chainage or distance, and y, z, elevation or "
        "level) nor those of boreholes (hole, x, elevation, and bottom and soil, or the depth of each boundary); it "
        "has {}",
        text_.file(), clean_text(list));
  }
  if (form_ != TableForm::holes) {
    for (const DepthColumn& column : depths_) unused_.push_back(column.soil);
    depths_.clear();
  }
}

void SurveyTable::refuse_headings() const {
  std::size_t numbers = 0;
  bool has_latitude = false, has_longitude = false;
  for (const auto& heading : text_.header()) {
    const char* const end = heading.name.data() + heading.name.size();
    double value = 0;
    if (!heading.name.empty() && parse_number(heading.name.data(), end, value) == end) ++numbers;
    const std::string key = read_heading(heading).key;
    has_latitude = has_latitude || is_latitude(key);
    has_longitude = has_longitude || is_longitude(key);
  }
  if (has_latitude && has_longitude)
    fail_input("the positions of '{}' are latitudes and longitudes; give eastings and northings of a map projection",
               text_.file());
  if (numbers >= 2)
    fail_input(
        "'{}' has numbers and texts in its first line and no headings; name its columns in a first line, for "
        "example name, x, y, z, code",
        text_.file());
}

void SurveyTable::read_units_row() {
  if (text_.rows() == 0) return;
  bool is_row_of_units = false;
  const auto take = [&](std::size_t number, double& factor, bool& has_unit) {
    std::string cell = text_.cell(0, number);
    if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
    const std::string unit = find_length_unit(cell);
    if (unit.empty()) return;
    is_row_of_units = has_unit = true;
    factor = units::parse_as_si("1 " + unit, "m", "the unit of a column");
  };
  for (auto& column : columns_)
    if (column && column->factor > 0) take(column->number, column->factor, column->has_unit);
  for (DepthColumn& column : depths_) take(column.column, column.factor, column.has_unit);
  if (!is_row_of_units) return;
  // In AGS data a row of types, such as 2DP, follows.
  first_row_ = 1;
  const auto is_type = [&](const std::optional<Column>& column) {
    const std::string cell = column && text_.rows() > 1 ? text_.cell(1, column->number) : "";
    return cell.size() == 3 && (cell.ends_with("DP") || cell.ends_with("SF"));
  };
  if (std::any_of(columns_.begin(), columns_.end(), is_type)) first_row_ = 2;
}

double SurveyTable::read_number(std::size_t row, std::size_t column) const {
  const std::string cell = text_.cell(row, column);
  const std::size_t plus = cell.find('+');
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto count_digits = [&](std::size_t from) {
    return static_cast<std::size_t>(
               std::find_if_not(cell.begin() + static_cast<std::ptrdiff_t>(from), cell.end(), is_digit) -
               cell.begin()) -
           from;
  };
  if (plus == std::string::npos || plus == 0 || count_digits(0) != plus) return text_.number(row, column);
  const std::size_t digits = count_digits(plus + 1);
  double stations = 0, rest = 0;
  const char *const from = cell.data(), *const end = from + cell.size();
  if ((digits != 2 && digits != 3) || parse_number(from, from + plus, stations) != from + plus ||
      parse_number(from + plus + 1, end, rest) != end)
    fail_input("{}: '{}' is not a station: two or three digits are expected after '+', as in 0+012.5 or 12+50",
               text_.place(row), cell);
  return stations * (digits == 3 ? 1000 : 100) + rest;
}

bool SurveyTable::is_numeric(std::size_t column) const {
  constexpr std::size_t most_tries = 20;
  for (std::size_t row = 0; row < std::min(text_.rows(), most_tries); ++row) {
    if (input::is_missing(text_.cell(row, column), -99)) continue;
    try {
      read_number(row, column);
      return true;
    } catch (const Error&) {
      continue;
    }
  }
  return text_.rows() == 0;
}

bool SurveyTable::has_text(std::size_t column) const {
  for (std::size_t row = 0; row < text_.rows(); ++row)
    if (const std::string cell = text_.cell(row, column); !cell.empty() && cell != "X" && cell != "PA") return true;
  return text_.rows() == 0;
}

std::optional<double> SurveyTable::read_length(std::size_t row, const DepthColumn& column) const {
  if (input::is_missing(text_.cell(row, column.column), -99)) return std::nullopt;
  const double value = read_number(row, column.column) * column.factor;
  constexpr double farthest = 1e9;  // [m]
  if (!(std::abs(value) < farthest)) fail_input("{}: {:.6g} m is too far away", text_.place(row), value);
  return value;
}

std::optional<double> SurveyTable::read_length(std::size_t row, Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  if (!column) return std::nullopt;
  return read_length(row, {"", column->number, column->factor, column->has_unit});
}

std::optional<PlanPlace> SurveyTable::read_place(std::size_t row) const {
  const bool is_chainage = has(Role::chainage);
  const auto x = read_length(row, is_chainage ? Role::chainage : Role::x), northing = read_length(row, Role::northing);
  if (!x || (!is_chainage && has(Role::northing) && !northing)) return std::nullopt;
  return PlanPlace{*x, is_chainage ? std::nan("") : northing.value_or(std::nan(""))};
}

std::string SurveyTable::get_heading(Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column ? text_.header()[column->number].name : "";
}

double SurveyTable::get_assumed_unit(Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column && !column->has_unit ? column->factor : 1;
}

double SurveyTable::read_order(std::size_t row) const {
  return text_.number(row, columns_[static_cast<std::size_t>(Role::order)]->number);
}

std::string SurveyTable::read_text(std::size_t row, Role role) const {
  const auto& column = columns_[static_cast<std::size_t>(role)];
  return column ? text_.cell(row, column->number) : "";
}

bool SurveyTable::has_units() const {
  const auto has_unit = [](const auto& column) { return !column || column->factor == 0 || column->has_unit; };
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Role role = static_cast<Role>(i);
    const bool is_used = !has(Role::chainage) || (role != Role::x && role != Role::northing);
    if (is_used && !has_unit(columns_[i])) return false;
  }
  return std::all_of(depths_.begin(), depths_.end(), [](const DepthColumn& d) { return d.has_unit; });
}

std::string SurveyTable::describe() const {
  std::string columns;
  for (const Role role : {Role::hole, Role::chainage, Role::x, Role::northing, Role::elevation, Role::top, Role::bottom,
                          Role::bottom_level, Role::thickness, Role::end, Role::soil, Role::order})
    if (has(role) && !(has(Role::chainage) && (role == Role::x || role == Role::northing)))
      columns += fmt::format("{}'{}'", columns.empty() ? "" : ", ", get_heading(role));
  if (text_.header().front().name == "1" && text_.header().size() == 3) columns += " as x, y and z";
  std::string sentence = fmt::format("{}{} has {}; columns used: {}", std::filesystem::path(file()).filename().string(),
                                     part_.empty() ? "" : ", group " + part_, name_form(form_), columns);
  if (!depths_.empty()) sentence += fmt::format(" and {} depths", depths_.size());
  if (!unused_.empty()) {
    constexpr std::size_t most_named = 8;
    sentence += "; not used: ";
    for (std::size_t i = 0; i < std::min(unused_.size(), most_named); ++i)
      sentence += fmt::format("{}'{}'", i == 0 ? "" : ", ", unused_[i]);
    if (unused_.size() > most_named) sentence += fmt::format(" and {} more", unused_.size() - most_named);
  }
  if (preamble_ > 0)
    sentence += fmt::format("; {} line{} above the headings{}", preamble_, preamble_ == 1 ? "" : "s",
                            preamble_unit_.empty() ? " not used" : ", of which the unit is used: " + preamble_unit_);
  if (is_converted_) sentence += "; it is not UTF-8 and was read as Latin-1";
  return sentence + (has_units() ? "" : "; lengths without a unit");
}

std::vector<SurveyTable> read_survey_tables(const std::string& path, double unit) {
  std::vector<SurveyTable> tables;
  if (!is_ags(path)) {
    tables.emplace_back(path, unit);
    return tables;
  }
  for (AgsGroup& group : read_ags(path)) {
    make_utf8(group.text);
    tables.emplace_back(input::TextTable(path, std::move(group.text), group.first_line), group.name, unit);
  }
  return tables;
}

}  // namespace talus::drawing
