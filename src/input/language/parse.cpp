// SPDX-License-Identifier: MIT
#include "input/language/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"

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

/// Returns the last number with a decimal comma before `column` of a line; empty if there is none.
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

/// Returns the unquoted value around `column` of a line; empty if the value is quoted or missing. The parser counts
/// characters, and its column is within the value or one before it.
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

/// Returns a sentence on how to write a value with missing quotation marks; std::nullopt for other faults.
std::optional<std::string> explain_bare_value(const std::string& value) {
  if (value == "True" || value == "False")
    return fmt::format("'{}' is written in small letters: {}", value, value == "True" ? "true" : "false");
  const bool is_word = !value.empty() && (std::isalpha(static_cast<unsigned char>(value[0])) != 0 || value[0] == '_');
  if (is_word) return fmt::format("put the text in quotation marks: \"{}\"", value);
  const std::size_t sign = !value.empty() && (value[0] == '+' || value[0] == '-') ? 1 : 0;
  double number = 0;
  const char* last = value.data() + value.size();
  const char* end = parse_number(value.data() + sign, last, number);
  if (end == nullptr || end == last) return std::nullopt;
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

/// Throws InputError if the text is not encoded in UTF-8.
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

/// Throws InputError if the text has more values than any section: the parser needs a hundred bytes for each.
void check_extent(const std::string& text, const std::string& name) {
  constexpr std::ptrdiff_t most_values = 1'000'000;
  const auto values = std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == '=' || c == '['; });
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

namespace {

/// Returns the end of the string that begins at `at`; a single-line string ends at its line's end at the latest.
std::size_t skip_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = text.substr(at, 3);
  const bool is_long = three.size() == 3 && three[1] == quote && three[2] == quote;
  const std::string_view end = is_long ? three : text.substr(at, 1);
  at += end.size();
  while (at < text.size() && text.substr(at, end.size()) != end) {
    if (!is_long && text[at] == '\n') return at;
    at += quote == '"' && text[at] == '\\' ? 2 : 1;
  }
  return std::min(at + end.size(), text.size());
}

TextPlace find_place(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t last = before.rfind('\n');
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          static_cast<int>(last == std::string_view::npos ? at + 1 : at - last)};
}

}  // namespace

std::optional<TextPlace> find_deep_key(std::string_view text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      i = skip_string(text, i);
      continue;
    }
    if (c == '.' && ++dots > most_dots) return find_place(text, i);
    if (std::string_view("=[]{},\n").find(c) != std::string_view::npos) dots = 0;
    ++i;
  }
  return std::nullopt;
}

namespace {

/// Returns true if the change removes a key, a table or an entry: `--set lem.drawdown=`.
bool is_removal(const Override& change) {
  return change.value.empty();
}

/// Returns the value as a table with the single key "v".
toml::table parse_value(const std::string& text) {
  try {
    toml::table table = find_deep_key(text) ? toml::table{} : toml::parse("v = " + text);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
    // The text is a bare word, or a quantity whose quotation marks the shell has removed.
  }
  toml::table table;
  table.insert("v", text);
  return table;
}

/// Returns the index of the list entry that `step` identifies: by index from 0, or by its `name`, `on` or `ground`.
/// has(i, label): entry i has this label with the value `step`.
std::optional<std::size_t> find_entry(std::size_t size, const std::string& step, const auto& has) {
  std::size_t number = 0;
  const auto [end, failure] = std::from_chars(step.data(), step.data() + step.size(), number);
  if (failure == std::errc{} && end == step.data() + step.size())
    return number < size ? std::optional(number) : std::nullopt;
  for (std::size_t i = 0; i < size; ++i)
    for (const char* label : {"name", "on", "ground"})
      if (has(i, label)) return i;
  return std::nullopt;
}
std::optional<std::size_t> find_entry(const toml::array& list, const std::string& step) {
  return find_entry(list.size(), step, [&](std::size_t i, const char* label) {
    const toml::table* table = list[i].as_table();
    return table != nullptr && (*table)[label].value<std::string>() == step;
  });
}

/// Blocks whose tables have user-defined names.
const std::set<std::string> blocks_of_names{"materials"};

/// Returns ", did you mean 'sand'?" from the names in a list or table; empty if none is similar.
std::string add_suggestion(const std::string& step, const std::vector<std::string>& names) {
  const std::string near = find_nearest(step, names);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

std::vector<std::string> list_names(const toml::table& table) {
  std::vector<std::string> names;
  for (const auto& [key, node] : table) names.emplace_back(key.str());
  return names;
}

/// Returns the labels of the entries of a list.
std::vector<std::string> list_labels(const toml::array& list) {
  std::vector<std::string> names;
  for (const toml::node& entry : list)
    if (const toml::table* table = entry.as_table())
      for (const char* label : {"name", "on", "ground"})
        if (const auto name = (*table)[label].value<std::string>()) names.push_back(*name);
  return names;
}

void apply(toml::table& root, const Override& change, Findings& findings) {
  const std::vector<std::string> steps = split_path(change.key);
  const auto fail = [&](const std::string& sentence) {
    findings.add_at({"--set " + change.key, 0, 0}, change.key, sentence);
  };
  if (steps.size() > most_dots) return fail(fmt::format("the key has more than {} parts", most_dots));
  toml::node* at = &root;
  std::string path;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_last = i + 1 == steps.size();
    std::string step = steps[i];
    if (step.empty()) return fail("the key has an empty part between its dots");
    if (toml::array* list = at->as_array()) {
      const auto entry = find_entry(*list, step);
      if (!entry)
        return fail(fmt::format(
            "'{}' has no entry '{}' (entries are named by their name, their side, or their number from 0){}", path,
            step, add_suggestion(step, list_labels(*list))));
      step = std::to_string(*entry);
      path += "." + step;
      toml::node& child = (*list)[*entry];
      if (!is_last) {
        at = &child;
        continue;
      }
      const auto place_in_list = list->cbegin() + static_cast<std::ptrdiff_t>(*entry);
      if (is_removal(change)) {
        list->erase(place_in_list);
        return;
      }
      toml::table value = parse_value(change.value);
      value.get("v")->visit([&](auto& v) { list->replace(place_in_list, v); });
    } else if (toml::table* table = at->as_table()) {
      path += (path.empty() ? "" : ".") + step;
      if (!is_last) {
        if (table->get(step) == nullptr) {
          const std::string parent = path.substr(0, path.size() - step.size() - (path.size() > step.size() ? 1 : 0));
          if (blocks_of_names.count(parent) != 0)
            return fail(fmt::format("there is no [{}]{}", path, add_suggestion(step, list_names(*table))));
          table->insert(step, toml::table{});
          findings.places.mark_override(path, change.key);
        }
        at = table->get(step);
        continue;
      }
      if (is_removal(change)) {
        if (table->erase(step) == 0)
          fail(fmt::format("the file has no '{}' to remove{}", path, add_suggestion(step, list_names(*table))));
        return;
      }
      toml::table value = parse_value(change.value);
      value.get("v")->visit([&](auto& v) { table->insert_or_assign(step, v); });
    } else {
      return fail(fmt::format("'{}' is a value and has no key '{}'", path, step));
    }
  }
  findings.places.mark_override(path, change.key);
}

}  // namespace

const nlohmann::json* find_entry(const nlohmann::json& list, const std::string& step) {
  const auto found = find_entry(list.size(), step, [&](std::size_t i, const char* label) {
    return list[i].contains(label) && list[i][label].value("value", nlohmann::json()) == step;
  });
  return found ? &list[*found] : nullptr;
}

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.')
      steps.emplace_back();
    else
      steps.back() += c;
  }
  return steps;
}

Override parse_override(const std::string& text) {
  const auto equals = text.find('=');
  const auto trim = [](const std::string& part) {
    const auto first = part.find_first_not_of(" \t");
    return first == std::string::npos ? std::string() : part.substr(first, part.find_last_not_of(" \t") - first + 1);
  };
  Override change;
  if (equals != std::string::npos) change = {trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
  if (change.key.empty())
    fail_input("--set '{}' must be written key=value, for example --set materials.sand.cohesion=5", text);
  return change;
}

void apply_overrides(toml::table& root, const std::vector<Override>& overrides, Findings& findings) {
  for (const Override& change : overrides) apply(root, change, findings);
}

}  // namespace talus::input
