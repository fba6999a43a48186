// SPDX-License-Identifier: MIT
#include "input/language/apply_overrides.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/nearest.hpp"
#include "input/language/deep_keys.hpp"

namespace talus::input {
namespace {

/// A change that takes a key, a table or an entry out of the file: `--set lem.drawdown=`.
bool is_removal(const Override& change) {
  return change.value.empty();
}

/// The value as a table with the one key "v".
toml::table parse_value(const std::string& text) {
  try {
    toml::table table = find_deep_key(text) ? toml::table{} : toml::parse("v = " + text);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
    // A bare word, or a quantity without quotation marks: the shell took them away.
  }
  toml::table table;
  table.insert("v", text);
  return table;
}

/// The entry of a list that `step` names: by number from 0, or by its `name`, `on` or `ground`.
std::optional<std::size_t> find_entry(const toml::array& list, const std::string& step) {
  std::size_t number = 0;
  const auto [end, failure] = std::from_chars(step.data(), step.data() + step.size(), number);
  if (failure == std::errc{} && end == step.data() + step.size())
    return number < list.size() ? std::optional(number) : std::nullopt;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const toml::table* table = list[i].as_table();
    if (table == nullptr) continue;
    for (const char* label : {"name", "on", "ground"})
      if ((*table)[label].value<std::string>() == step) return i;
  }
  return std::nullopt;
}

/// Blocks whose tables have names of the user's choice.
const std::set<std::string> blocks_of_names{"materials"};

/// ", did you mean 'sand'?" of the names that a list or table has; empty where none is near.
std::string suggest(const std::string& step, const std::vector<std::string>& names) {
  const std::string near = find_nearest(step, names);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

std::vector<std::string> list_names(const toml::table& table) {
  std::vector<std::string> names;
  for (const auto& [key, node] : table) names.emplace_back(key.str());
  return names;
}

/// What entries of a list are called.
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
  const Place place{"--set " + change.key, 0, 0};
  if (steps.size() > most_dots)
    return findings.add_at(place, change.key, fmt::format("the key has more than {} parts", most_dots));
  toml::node* at = &root;
  std::string path;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_last = i + 1 == steps.size();
    std::string step = steps[i];
    if (step.empty()) return findings.add_at(place, change.key, "the key has an empty part between its dots");
    if (toml::array* list = at->as_array()) {
      const auto entry = find_entry(*list, step);
      if (!entry)
        return findings.add_at(place, change.key,
                               fmt::format("'{}' has no entry '{}' (entries are named by their name, their side, or "
                                           "their number from 0){}",
                                           path, step, suggest(step, list_labels(*list))));
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
            return findings.add_at(place, change.key,
                                   fmt::format("there is no [{}]{}", path, suggest(step, list_names(*table))));
          table->insert(step, toml::table{});
          findings.places.mark_override(path, change.key);
        }
        at = table->get(step);
        continue;
      }
      if (is_removal(change)) {
        if (table->erase(step) == 0)
          findings.add_at(place, change.key,
                          fmt::format("the file has no '{}' to remove{}", path, suggest(step, list_names(*table))));
        return;
      }
      toml::table value = parse_value(change.value);
      value.get("v")->visit([&](auto& v) { table->insert_or_assign(step, v); });
    } else {
      return findings.add_at(place, change.key, fmt::format("'{}' is a value and has no key '{}'", path, step));
    }
  }
  findings.places.mark_override(path, change.key);
}

}  // namespace

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
    throw Error(ExitCode::wrong_input, fmt::format("--set '{}' must be written key=value, for example "
                                                   "--set materials.sand.cohesion=5",
                                                   text));
  return change;
}

void apply_overrides(toml::table& root, const std::vector<Override>& overrides, Findings& findings) {
  for (const Override& change : overrides) apply(root, change, findings);
}

}  // namespace talus::input
