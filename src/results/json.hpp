// SPDX-License-Identifier: MIT
#pragma once
// Conversion of results to and from JSON, and their JSON Schema and table for the manual. This is the only interface to
// the JSON of results; the keys are those of the describe() functions.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace talus::results {

/// Converts a result to JSON. It is instantiated for the structs with a file of their own and for parts that the
/// page of a study shows.
template <class T>
nlohmann::json to_json(const T& result);

/// Converts JSON to a result. Missing keys keep the defaults of the struct. Throws Error (wrong_input) with the place
/// in `file` if a value has the wrong type.
template <class T>
T from_json(const nlohmann::json& tree, const std::string& file);

/// Reads the file at `path`; returns nullopt if there is none. Throws Error (wrong_input) if it is not JSON, if its
/// `format` is that of another version, or as from_json().
template <class T>
std::optional<T> read_file(const std::filesystem::path& path);

/// Same, but returns nullopt also for a damaged file or one of another version. It is for files that only save
/// computing time.
template <class T>
std::optional<T> find_file(const std::filesystem::path& path);

/// Writes a result with `indent` spaces a level (-1: on one line). Throws Error (cannot_write); its message names with
/// `safe` what remains intact.
template <class T>
void write_file(const std::filesystem::path& path, const T& result, int indent = 2, const std::string& safe = "");

/// Returns the JSON Schema of summary.json for `talus schema --results`. Its types include those of study.json,
/// point.json and calibration.json, from which the page generates its own (web/contract/types.mjs).
std::string write_schema();

/// Returns every key of summary.json with unit and title as a Markdown table for `talus manual --results`.
std::string write_manual();

}  // namespace talus::results
