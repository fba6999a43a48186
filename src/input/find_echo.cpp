// SPDX-License-Identifier: MIT
// Keys of a case by their paths, from its echo.

#include <charconv>
#include <nlohmann/json.hpp>

#include "input/echo.hpp"
#include "input/language/overrides.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

/// The entry of an echo's list that `step` names, as --set names it: by number from 0, by its name or its side.
const json* find_entry(const json& list, const std::string& step) {
  std::size_t number = 0;
  const char* end = step.data() + step.size();
  if (const auto [stop, failure] = std::from_chars(step.data(), end, number); failure == std::errc{} && stop == end)
    return number < list.size() ? &list[number] : nullptr;
  for (const json& entry : list)
    for (const char* label : {"name", "on"})
      if (entry.contains(label) && entry[label].value("value", "") == step) return &entry;
  return nullptr;
}

std::string write_value(const json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_number_float()) return value.dump();
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value.get<double>()).ptr};
}

json strip_given(const json& echo) {
  json stripped = echo;
  if (stripped.is_object()) stripped.erase("given");
  if (stripped.is_structured())
    for (json& child : stripped) child = strip_given(child);
  return stripped;
}

}  // namespace

std::optional<EchoedKey> find_key(const JsonTree& echo, const std::string& path) {
  const json* at = &echo.get();
  for (const std::string& step : split_path(path)) {
    if (at->is_array())
      at = find_entry(*at, step);
    else
      at = at->is_object() && at->contains(step) ? &(*at)[step] : nullptr;
    if (at == nullptr) return std::nullopt;
  }
  if (!at->is_object() || !at->contains("value")) return std::nullopt;
  return EchoedKey{write_value(at->at("value")), at->value("unit", "")};
}

std::string write_calculated(const JsonTree& echo) {
  return strip_given(echo.get()).dump();
}

}  // namespace talus::input
