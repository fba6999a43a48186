// SPDX-License-Identifier: MIT
#include "studio/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/numbers.hpp"
#include "input/echo.hpp"

namespace talus::studio {
namespace {

using nlohmann::json;

json write_number(double value) {
  return std::isfinite(value) ? json(value) : json();
}

std::string write_key(const input::ListedKey& key) {
  return key.number ? write_shortest(*key.number) : key.text;
}

/// Adds the keys that differ, in the order of the first run; those that only the second has follow.
json compare_inputs(const results::RunResult& first, const results::RunResult& second) {
  json list = json::array();
  std::map<std::string, input::ListedKey> others;
  const std::vector<input::ListedKey> own = input::list_keys(first.input), theirs = input::list_keys(second.input);
  for (const input::ListedKey& key : theirs) others.emplace(key.path, key);
  for (const input::ListedKey& key : own) {
    const auto other = others.find(key.path);
    const bool is_shared = other != others.end();
    const std::string one = write_key(key), two = is_shared ? write_key(other->second) : "";
    const bool is_equal = is_shared && one == two && key.unit == other->second.unit;
    if (!is_equal)
      list.push_back(
          {{"key", key.path}, {"first", one}, {"second", is_shared ? json(two) : json()}, {"unit", key.unit}});
    if (is_shared) others.erase(other);
  }
  for (const input::ListedKey& key : theirs)
    if (others.contains(key.path))
      list.push_back({{"key", key.path}, {"first", nullptr}, {"second", write_key(key)}, {"unit", key.unit}});
  return list;
}

const results::NamedResult* find_result(const results::RunResult& run, const std::string& name) {
  const auto found = std::find_if(run.results.begin(), run.results.end(),
                                  [&](const results::NamedResult& result) { return result.name == name; });
  return found == run.results.end() ? nullptr : &*found;
}

/// Returns the number in the unit of display, or "not determined".
json write_value(const results::NamedResult& result, double unit) {
  return result.value ? json(write_number(*result.value / unit)) : json("not determined");
}

json write_difference(const results::NamedResult* first, const results::NamedResult* second) {
  const results::NamedResult& shown = first != nullptr ? *first : *second;
  const auto in_unit = [&](const results::NamedResult* result) {
    return result == nullptr ? json() : write_value(*result, shown.unit.si);
  };
  json out{{"name", shown.name},        {"title", shown.title},  {"unit", shown.unit.name}, {"first", in_unit(first)},
           {"second", in_unit(second)}, {"difference", nullptr}, {"relative", nullptr}};
  if (first == nullptr || second == nullptr || !first->value || !second->value) return out;
  const double difference = *second->value - *first->value;
  out["difference"] = write_number(difference / shown.unit.si);
  if (*first->value != 0) out["relative"] = write_number(difference / std::abs(*first->value));
  return out;
}

json list_warnings(const results::RunResult& first, const results::RunResult& second) {
  json list = json::array();
  const auto describe = [](const results::RunResult& run) {
    return fmt::format("{} ({})", run.provenance.version, run.provenance.commit);
  };
  if (describe(first) != describe(second))
    list.push_back(fmt::format("The runs are by different programs: {} and {}.", describe(first), describe(second)));
  const auto add_status = [&](const char* word, const results::RunResult& run) {
    if (run.status != results::Status::finished)
      list.push_back(
          fmt::format("The {} run is {}: its results are those so far.", word, results::to_word(run.status)));
  };
  add_status("first", first);
  add_status("second", second);
  return list;
}

}  // namespace

json list_run(const results::RunResult& run) {
  json values = json::array(), surfaces = json::array();
  for (const results::NamedResult& result : run.results)
    values.push_back({{"name", result.name},
                      {"title", result.title},
                      {"unit", result.unit.name},
                      {"value", write_value(result, result.unit.si)}});
  if (run.methods)
    for (const results::MethodSurface& surface : run.methods->surfaces) {
      json& out = surfaces.emplace_back();
      out = {{"name", surface.name},
             {"title", surface.title},
             {"method", results::to_word(surface.method)},
             {"factor", nullptr},
             {"points", surface.points}};
      if (surface.factor) out["factor"] = write_number(*surface.factor);
    }
  return {{"title", run.title},          {"status", results::to_word(run.status)}, {"program", run.provenance.version},
          {"values", std::move(values)}, {"surfaces", std::move(surfaces)},        {"warnings", run.warnings}};
}

json compare_runs(const results::RunResult& first, const results::RunResult& second) {
  json values = json::array();
  for (const results::NamedResult& result : first.results)
    values.push_back(write_difference(&result, find_result(second, result.name)));
  for (const results::NamedResult& result : second.results)
    if (find_result(first, result.name) == nullptr) values.push_back(write_difference(nullptr, &result));
  return {{"inputs", compare_inputs(first, second)},
          {"values", std::move(values)},
          {"warnings", list_warnings(first, second)}};
}

}  // namespace talus::studio
