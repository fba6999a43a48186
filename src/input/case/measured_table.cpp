// SPDX-License-Identifier: MIT
#include "input/case/measured_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/units.hpp"

namespace talus::input {
namespace {

std::string trim(const std::string& text) {
  const char* blank = " \t\r\"";
  const auto first = text.find_first_not_of(blank);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == separator)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trim(cell);
  return cells;
}

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

/// A column of the header: "axial_strain [%]".
struct Heading {
  std::string name, unit;
};

Heading read_heading(const std::string& cell) {
  const auto bracket = cell.find('[');
  if (bracket == std::string::npos || cell.back() != ']') return {cell, ""};
  return {trim(cell.substr(0, bracket)), trim(cell.substr(bracket + 1, cell.size() - bracket - 2))};
}

struct Column {
  std::size_t number = 0;
  double factor = 1;
};

Column find_column(const std::string& file, const std::vector<Heading>& header, const PointQuantity& quantity) {
  std::vector<std::string> names;
  std::string list;
  for (const Heading& h : header) {
    names.push_back(h.name);
    list += (list.empty() ? "'" : ", '") + h.name + "'";
  }
  const auto found = std::find(names.begin(), names.end(), quantity.name);
  if (found == names.end()) {
    // p is near to q in letters alone.
    const std::string near = std::string(quantity.name).size() < 3 ? "" : find_nearest(quantity.name, names);
    fail(fmt::format("'{}' has no column '{}'; {}", file, quantity.name,
                     near.empty() ? "it has " + list : fmt::format("is it '{}'?", near)));
  }
  const auto number = static_cast<std::size_t>(found - names.begin());
  const std::string& unit = header[number].unit;
  if (unit.empty() && std::string(quantity.unit) == "Pa")
    fail(fmt::format("the column '{0}' of '{1}' has no unit; head it '{0} [kPa]' or with another stress", quantity.name,
                     file));
  try {
    return {number, find_measured_factor(quantity, unit)};
  } catch (const Error& error) {
    fail(fmt::format("the column '{}' of '{}': {}", quantity.name, file, error.what()));
  }
}

double read_number(std::string cell, bool has_comma, const std::string& place) {
  if (has_comma) std::replace(cell.begin(), cell.end(), ',', '.');
  double value = 0;
  const char* begin = cell.data() + (cell[0] == '+' ? 1 : 0);
  const auto [end, failure] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (failure != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    fail(fmt::format("{}: '{}' is no number", place, cell));
  return value;
}

}  // namespace

const PointQuantity* find_point_quantity(const std::string& name) {
  const auto& list = list_point_quantities();
  const auto found = std::find_if(list.begin(), list.end(), [&](const PointQuantity& q) { return name == q.name; });
  return found == list.end() ? nullptr : &*found;
}

double find_measured_factor(const PointQuantity& quantity, const std::string& unit) {
  if (unit.empty() || unit == "-") {
    if (std::string(quantity.unit) == "Pa" && unit == "-")
      fail(fmt::format("'{}' is a stress and needs a unit such as kPa", quantity.name));
    return 1;
  }
  const std::string wanted = std::string(quantity.unit) == "Pa" ? "Pa" : "1";
  return units::parse_as_si("1 " + unit, wanted, quantity.name);
}

std::vector<std::array<double, 2>> read_measured_table(const std::filesystem::path& path, const PointQuantity& x,
                                                       const PointQuantity& y) {
  const std::string file = path.string();
  std::ifstream stream(path);
  if (!stream || std::filesystem::is_directory(path))
    fail(fmt::format("there is no table '{}'; its path is relative to the case file", file));
  std::vector<std::array<double, 2>> rows;
  std::string line;
  char separator = 0;
  Column columns[2];
  for (int number = 1; std::getline(stream, line); ++number) {
    if (number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // as spreadsheets begin their texts
    if (trim(line).empty() || trim(line)[0] == '#') continue;
    if (separator == 0) {
      separator = line.find(';') != std::string::npos ? ';' : line.find('\t') != std::string::npos ? '\t' : ',';
      std::vector<Heading> header;
      for (const std::string& cell : split(line, separator)) header.push_back(read_heading(cell));
      columns[0] = find_column(file, header, x);
      columns[1] = find_column(file, header, y);
      continue;
    }
    const std::vector<std::string> cells = split(line, separator);
    const auto get = [&](const Column& c) { return c.number < cells.size() ? cells[c.number] : std::string(); };
    if (get(columns[0]).empty() || get(columns[1]).empty()) continue;
    std::array<double, 2>& row = rows.emplace_back();
    for (std::size_t k = 0; k < 2; ++k)
      row[k] = columns[k].factor * read_number(get(columns[k]), separator == ';', fmt::format("{}:{}", file, number));
  }
  if (rows.empty()) fail(fmt::format("the table '{}' has no row with '{}' and '{}'", file, x.name, y.name));
  return rows;
}

}  // namespace talus::input
