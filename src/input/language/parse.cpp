// SPDX-License-Identifier: MIT
#include "input/language/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>

#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "input/language/deep_keys.hpp"

namespace talus::input {
namespace {

std::string find_line(const std::string& text, toml::source_index number) {
  std::istringstream lines(text);
  std::string line;
  for (toml::source_index i = 0; i < number; ++i) std::getline(lines, line);
  return line;
}

std::string trim(const std::string& text) {
  const char* blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// The number with a decimal comma that stands last before a place of a line; empty where there is none.
std::string find_decimal_comma(const std::string& line, toml::source_index column) {
  const auto skip_digits = [&](std::size_t i) {
    while (i < line.size() && std::isdigit(static_cast<unsigned char>(line[i])) != 0) ++i;
    return i;
  };
  std::string found;
  for (std::size_t equals = line.find('='); equals != std::string::npos; equals = line.find('=', equals + 1)) {
    const std::size_t begin = line.find_first_not_of(" \t+-", equals + 1);
    if (begin == std::string::npos) break;
    const std::size_t comma = skip_digits(begin);
    if (comma == begin || comma >= line.size() || line[comma] != ',' || comma > column) continue;
    const std::size_t end = skip_digits(comma + 1);
    if (end > comma + 1) found = line.substr(begin, end - begin);
  }
  return found;
}

/// The value without quotation marks around a place of a line; empty where it has some, or where nothing stands. The
/// parser counts characters, and its place lies within the value or at the character before it.
std::string find_bare_value(const std::string& line, toml::source_index column) {
  std::size_t at = 0;
  for (toml::source_index i = 1; at < line.size() && i < column; ++i) do
      ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80);
  const std::size_t before = line.find_last_of("=[,{", at == 0 ? 0 : at - 1);
  if (before == std::string::npos) return "";
  const std::string value = trim(line.substr(before + 1, line.find_first_of(",]}#", before + 1) - before - 1));
  return value.find_first_of("\"'=[{") == std::string::npos ? value : "";
}

/// A sentence on how to write a value that misses its quotation marks; nothing for another fault.
std::optional<std::string> explain_bare_value(const std::string& value) {
  if (value == "True" || value == "False")
    return fmt::format("'{}' is written in small letters: {}", value, value == "True" ? "true" : "false");
  const bool is_word = !value.empty() && (std::isalpha(static_cast<unsigned char>(value[0])) != 0 || value[0] == '_');
  if (is_word) return fmt::format("put the text in quotation marks: \"{}\"", value);
  const std::size_t sign = !value.empty() && (value[0] == '+' || value[0] == '-') ? 1 : 0;
  double number = 0;
  const char* last = value.data() + value.size();
  const auto [end, failure] = std::from_chars(value.data() + sign, last, number);
  if (failure != std::errc{} || end == last) return std::nullopt;
  const std::string unit = trim(std::string(end, last));
  if (std::isdigit(static_cast<unsigned char>(unit[0])) != 0 || unit.find_first_of(".:_-+") == 0) return std::nullopt;
  return fmt::format("put the value with its unit in quotation marks: \"{}\"", value);
}

std::string explain(const std::string& text, const toml::parse_error& error) {
  const toml::source_position at = error.source().begin;
  const std::string line = find_line(text, at.line);
  if (const std::string comma = find_decimal_comma(line, at.column); !comma.empty())
    return units::explain_decimal_comma(comma);
  if (const auto sentence = explain_bare_value(find_bare_value(line, at.column))) return *sentence;
  return fmt::format("this is not TOML: {}", error.description());
}

/// Throws InputError for a text in another encoding than UTF-8.
void check_encoding(const std::string& text, const std::string& name) {
  if (is_utf16(text)) throw InputError({{name, 0, 0, "the file is in UTF-16; save it as UTF-8"}});
  const auto wrong = find_wrong_utf8(text);
  if (!wrong) return;
  const std::string before = text.substr(0, *wrong);
  int line = 1, column = 1;
  for (const char c : before) {
    if (c == '\n')
      ++line, column = 1;
    else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80)
      ++column;
  }
  throw InputError({{name, line, column,
                     "this character is not UTF-8; the file has another encoding, such as Latin-1 or Windows-1252: "
                     "save it as UTF-8"}});
}

/// Throws InputError for a text with more values than any section has: the parser takes a hundred bytes for each.
void check_extent(const std::string& text, const std::string& name) {
  constexpr std::ptrdiff_t most_values = 1'000'000;
  const auto values = std::ranges::count_if(text, [](char c) { return c == ',' || c == '=' || c == '['; });
  if (values > most_values)
    throw InputError({{name, 0, 0,
                       fmt::format("the file has about {} values, and a case has at most {}; tables in time stand in a "
                                   "CSV file of their own",
                                   values, most_values)}});
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& name) {
  check_encoding(text, name);
  check_extent(text, name);
  if (const auto place = find_deep_key(text))
    throw InputError({{name, place->line, place->column, fmt::format("this key has more than {} parts", most_dots)}});
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError({{name, static_cast<int>(at.line), static_cast<int>(at.column), explain(text, error)}});
  }
}

}  // namespace talus::input
