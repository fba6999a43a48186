// SPDX-License-Identifier: MIT
#pragma once
// Conversion of results to and from JSON, and their JSON Schema and table for the manual. This is the only interface to
// the JSON of results; the keys are those of the describe() functions.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "results/described.hpp"

namespace talus::results {

/// Converts a result, or a described part of one, to JSON.
nlohmann::json write_json(Value value);
template <class T>
auto to_json(const T& result) {
  return write_json(make_value(result));
}

/// Converts JSON to a result. Missing keys keep the defaults of the struct. Throws Error (wrong_input) with the place
/// in `file` if a value has the wrong type.
void read_json(const nlohmann::json& tree, Value out, const std::string& file);
template <class T>
T from_json(const nlohmann::json& tree, const std::string& file) {
  T result{};
  read_json(tree, make_value(result), file);
  return result;
}

/// Results whose file tells the version of its format.
template <class T>
inline constexpr bool has_format = requires(T result) {
  result.format;
};

/// Reads the file at `path`; returns nullopt if there is none. Throws Error (wrong_input) if it is not JSON, if its
/// `format` is that of another version, or as from_json().
bool read_file(const std::filesystem::path& path, bool has_format, Value out);
template <class T>
std::optional<T> read_file(const std::filesystem::path& path) {
  std::optional<T> result(std::in_place);
  if (!read_file(path, has_format<T>, make_value(*result))) result.reset();
  return result;
}

/// Same, but returns nullopt also for a damaged file or one of another version. It is for files that only save
/// computing time.
bool find_file(const std::filesystem::path& path, bool has_format, Value out);
template <class T>
std::optional<T> find_file(const std::filesystem::path& path) {
  std::optional<T> result(std::in_place);
  if (!find_file(path, has_format<T>, make_value(*result))) result.reset();
  return result;
}

/// Writes a result with `indent` spaces a level (-1: on one line). Throws Error (cannot_write); its message names with
/// `safe` what remains intact.
void write_file(const std::filesystem::path& path, Value value, int indent, const std::string& safe);
template <class T>
void write_file(const std::filesystem::path& path, const T& result, int indent = 2, const std::string& safe = "") {
  write_file(path, make_value(result), indent, safe);
}

/// Returns the JSON Schema of summary.json for `talus schema --results`. Its types include those of study.json,
/// point.json and calibration.json, from which the page generates its own (web/contract/types.mjs).
std::string write_schema();

/// Returns every key of summary.json with unit and title as a Markdown table for `talus manual --results`.
std::string write_manual();

}  // namespace talus::results
