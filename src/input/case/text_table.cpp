// SPDX-License-Identifier: MIT
#include "input/case/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"

namespace talus::input {

namespace {

std::string_view trim(std::string_view text) {
  const char* blank = " \t\r\"";
  const auto first = text.find_first_not_of(blank);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

constexpr char blanks = ' ';  // columns that any number of blanks separate

/// Returns the length of the quoted text that `text` begins with, after blanks; 0 if it begins with none. A quotation
/// mark within it is doubled (RFC 4180).
std::size_t measure_quoted(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos || text[first] != '"') return 0;
  for (std::size_t i = first + 1; i < text.size(); ++i)
    if (text[i] == '"' && (i + 1 == text.size() || text[++i] != '"')) return i;
  return 0;
}

/// Removes the text before the next separator, and the separator, from the front of `text` and returns that text.
std::string_view take_part(std::string_view& text, char separator) {
  if (separator == blanks) text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  const std::size_t end = std::min(text.find(separator, measure_quoted(text)), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

std::size_t count_columns(std::string_view line, char separator) {
  std::size_t count = 0;
  if (separator == blanks) line = trim(line);
  const bool ends_open = separator != blanks && line.ends_with(separator);
  for (; !line.empty(); ++count) take_part(line, separator);
  return count + (ends_open ? 1 : 0);
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

TextTable::Heading read_heading(std::string_view cell) {
  const auto bracket = cell.find('[');
  if (bracket == std::string_view::npos || cell.back() != ']') return {std::string(cell), ""};
  return {std::string(trim(cell.substr(0, bracket))),
          std::string(trim(cell.substr(bracket + 1, cell.size() - bracket - 2)))};
}

/// Larger than the number of columns of any table of measurements.
constexpr std::size_t most_columns = 10000;

}  // namespace

TextTable::TextTable(const std::filesystem::path& path) : file_(path.string()) {
  if (const auto fault = try_user_file(path, largest_file::table, text_))
    fail_input(fault->is_missing ? fmt::format("there is no table '{}'; its path is relative to the case file", file_)
                                 : fmt::format("the table '{}' cannot be read: {}", file_, fault->why));
  read_rows(1);
}

TextTable::TextTable(std::string file, std::string text, int first_line)
    : file_(std::move(file)), text_(std::move(text)) {
  read_rows(first_line);
}

void TextTable::read_rows(int first_line) {
  if (is_utf16(std::string_view(text_).substr(0, text_.find('\n'))))
    fail_input("'{}' is in UTF-16; save it as UTF-8", file_);
  std::string_view rest = text_;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // byte order mark, which spreadsheets write
  for (int number = first_line; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    // A cell in quotation marks is no comment.
    const bool is_quoted =
        line.find_first_not_of(" \t") != std::string_view::npos && line[line.find_first_not_of(" \t")] == '"';
    if (trim(line).empty() || (!is_quoted && is_comment(trim(line)))) continue;
    if (separator_ == 0) {
      read_header(line);
      if (!is_headless_) continue;
    }
    rows_.push_back({static_cast<std::size_t>(line.data() - text_.data()), line.size(), number});
  }
}

void TextTable::read_header(std::string_view line) {
  const auto has = [&](char c) { return line.find(c) != std::string_view::npos; };
  std::string joined;
  if (!has(';') && !has('\t') && !has(',')) {
    // Among blanks, a unit belongs to the name before it: "x [m] depth [m]".
    for (const char c : trim(line)) {
      while (c == '[' && joined.ends_with(blanks)) joined.pop_back();
      joined += c;
    }
    line = joined;
  }
  separator_ = has(';') ? ';' : has('\t') ? '\t' : has(',') || !has(blanks) ? ',' : blanks;
  const std::size_t columns = count_columns(line, separator_);
  if (columns > most_columns) fail_input("'{}' has {} columns; a table has at most {}", file_, columns, most_columns);
  for (std::size_t i = 0; i < columns; ++i) header_.push_back(read_heading(trim(take_part(line, separator_))));
  double value = 0;
  is_headless_ = std::all_of(header_.begin(), header_.end(),
                             [&](const Heading& h) { return h.unit.empty() && try_number(h.name, value); });
  for (std::size_t i = 0; is_headless_ && i < columns; ++i) header_[i].name = std::to_string(i + 1);
}

bool TextTable::try_number(std::string text, double& value) const {
  if (separator_ == ';' || separator_ == '\t') std::replace(text.begin(), text.end(), ',', '.');
  const char* begin = text.data() + (text.rfind('+', 0) == 0 ? 1 : 0);
  const char* end = text.data() + text.size();
  return !text.empty() && parse_number(begin, end, value) == end && std::isfinite(value);
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
    // For names of one or two letters, edit distance is no measure of similarity: p is one letter from q.
    const std::string near = name.size() < 3 ? "" : find_nearest(name, names);
    fail_input("'{}' has no column '{}'; {}", file_, name,
               near.empty() ? "it has " + list : fmt::format("is it '{}'?", near));
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::string TextTable::cell(std::size_t row, std::size_t column) const {
  std::string_view rest = std::string_view(text_).substr(rows_[row].begin, rows_[row].size);
  for (; column > 0; --column) take_part(rest, separator_);
  return std::string(trim(take_part(rest, separator_)));
}

double TextTable::number(std::size_t row, std::size_t column) const {
  double value = 0;
  if (const std::string text = cell(row, column); !try_number(text, value))
    fail_input("{}: '{}' is not a number", place(row), text);
  return value;
}

std::string TextTable::place(std::size_t row) const {
  return fmt::format("{}:{}", file_, rows_[row].line);
}

}  // namespace talus::input
