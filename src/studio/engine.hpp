// SPDX-License-Identifier: MIT
#pragma once
// The engine of the studio: functions from the text of a case to JSON text. They use no POSIX, no threads and no clock,
// so that the page calls the same functions through a server or as WebAssembly (docs/decisions/0052-studio-server.md).

#include <string>

namespace talus::studio {

/// Name of a text without a file, in messages.
inline constexpr const char* unnamed_case = "case.toml";

// No function throws: an error is the answer {"error": "one sentence"}. Coordinates are in [m].

/// Checks the text of a case. Returns
///   messages  [{severity: "error" or "warning", key, text, line, column, span, place}]; `key` is the path of the key,
///             `span` its value in the text, or null, `place` a point of the section, or null
///   spans     {path: [begin, end]}: bytes of every value in the text; of a table its header, up to its last own key
///   keys      {path: [begin, end]}: bytes of every name of a key
///   section   what a canvas shows, as far as the text can be read; null without a plane section
///   ready     true for a slope without errors
/// Files that the text names are relative to the folder of `name`.
std::string check(const std::string& text, const std::string& name = unnamed_case);

/// Runs LEM on the text of a case. `options` is JSON:
///   methods   words of [lem] methods in place of those of the case
///   circles   at most about this many circles in one quick search, without polylines: for drawing
///   threads   number of threads, 1 by default; results do not depend on it
/// Returns {factor, method, title, surface: [[x, y]], circle: {centre, radius} or null, searched, surfaces: [{method,
/// title, factor, circular, points, circle, searched: false for a surface of the case}], messages}. Without options the
/// numbers are those of `talus run`, before limit analysis examines them.
std::string solve(const std::string& text, const std::string& options = "{}", const std::string& name = unnamed_case);

/// Returns the JSON Schema of case files, as `talus schema`.
std::string schema();

/// Returns a commented case file with every key, as `talus template`.
std::string template_text();

}  // namespace talus::studio
