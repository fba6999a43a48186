// SPDX-License-Identifier: MIT
#include "input/case/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

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

[[noreturn]] void report_fault(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

TextTable::Heading read_heading(const std::string& cell) {
  const auto bracket = cell.find('[');
  if (bracket == std::string::npos || cell.back() != ']') return {cell, ""};
  return {trim(cell.substr(0, bracket)), trim(cell.substr(bracket + 1, cell.size() - bracket - 2))};
}

}  // namespace

TextTable::TextTable(const std::filesystem::path& path) : file_(path.string()) {
  std::ifstream stream(path);
  if (!stream || std::filesystem::is_directory(path))
    report_fault(fmt::format("there is no table '{}'; its path is relative to the case file", file_));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (number == 1 && is_utf16(line)) report_fault(fmt::format("'{}' is in UTF-16; save it as UTF-8", file_));
    if (number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // as spreadsheets begin their texts
    if (trim(line).empty() || trim(line)[0] == '#') continue;
    if (separator_ == 0) {
      separator_ = line.find(';') != std::string::npos ? ';' : line.find('\t') != std::string::npos ? '\t' : ',';
      for (const std::string& cell : split(line, separator_)) header_.push_back(read_heading(cell));
      continue;
    }
    cells_.push_back(split(line, separator_));
    lines_.push_back(number);
  }
}

bool TextTable::has_column(const std::string& name) const {
  return std::any_of(header_.begin(), header_.end(), [&](const Heading& h) { return h.name == name; });
}

std::size_t TextTable::find_column(const std::string& name) const {
  std::vector<std::string> names;
  std::string list;
  for (const Heading& h : header_) {
    names.push_back(h.name);
    list += (list.empty() ? "'" : ", '") + h.name + "'";
  }
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    // p is near to q in letters alone.
    const std::string near = name.size() < 3 ? "" : find_nearest(name, names);
    report_fault(fmt::format("'{}' has no column '{}'; {}", file_, name,
                             near.empty() ? "it has " + list : fmt::format("is it '{}'?", near)));
  }
  return static_cast<std::size_t>(found - names.begin());
}

const std::string& TextTable::cell(std::size_t row, std::size_t column) const {
  static const std::string none;
  return column < cells_[row].size() ? cells_[row][column] : none;
}

double TextTable::number(std::size_t row, std::size_t column) const {
  std::string text = cell(row, column);
  if (separator_ == ';') std::replace(text.begin(), text.end(), ',', '.');
  double value = 0;
  const char* begin = text.data() + (text.rfind('+', 0) == 0 ? 1 : 0);
  const auto [end, failure] = std::from_chars(begin, text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    report_fault(fmt::format("{}: '{}' is no number", place(row), text));
  return value;
}

std::string TextTable::place(std::size_t row) const {
  return fmt::format("{}:{}", file_, lines_[row]);
}

}  // namespace talus::input
