// SPDX-License-Identifier: MIT
#pragma once
// The descriptions of results for people and editors: a JSON Schema, and a table for the manual.

#include <string>

namespace talus::results {

/// JSON Schema of summary.json: `talus schema --results`.
std::string write_schema();

/// Every key of summary.json with its unit and what it is, as a Markdown table: `talus manual --results`.
std::string write_manual();

}  // namespace talus::results
