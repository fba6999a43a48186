// SPDX-License-Identifier: MIT
#pragma once
// Results as JSON. This is the only place that knows how; the description of a struct says what it holds.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace talus::results {

/// Any struct of results/ that is a file of its own, or stands in one of the page's contract.
template <class T>
nlohmann::json to_json(const T& result);

/// Keys that are missing keep the defaults of the struct: older versions knew fewer. Throws Error (wrong_input) with
/// the place in `file` where something is not of its kind.
template <class T>
T from_json(const nlohmann::json& tree, const std::string& file);

/// The file at `path`; nothing where there is none. Throws Error (wrong_input) when it is no JSON, or as from_json().
template <class T>
std::optional<T> read_file(const std::filesystem::path& path);

/// Likewise; nothing also where it is damaged or of another version: such a file only saves time and can be
/// calculated again.
template <class T>
std::optional<T> find_file(const std::filesystem::path& path);

/// With `indent` spaces a level; -1: on one line. Throws Error (cannot_write), which says with `safe` what is not
/// harmed.
template <class T>
void write_file(const std::filesystem::path& path, const T& result, int indent = 2, const std::string& safe = "");

// The descriptions of results for people and editors: a JSON Schema, and a table for the manual.

/// JSON Schema of summary.json: `talus schema --results`.
std::string write_schema();

/// Every key of summary.json with its unit and what it is, as a Markdown table: `talus manual --results`.
std::string write_manual();

}  // namespace talus::results
