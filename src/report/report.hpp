// SPDX-License-Identifier: MIT
#pragma once
// The report of a results folder: one HTML file that needs nothing else (docs/manual/report.md).

#include <filesystem>
#include <vector>

#include "base/json_tree.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// The document of web/src/contract/ and the arrays beside it.
struct Content {
  JsonTree document;
  std::vector<PackedText> arrays;
};

/// Collects what `folder` holds: of a run, finished or not, or of a study. Throws Error (wrong_input) with one sentence
/// when it holds no results or one of its files is damaged.
Content collect_report(const std::filesystem::path& folder);

/// Writes `folder`/report.html, whole or not at all, and returns its path. Throws as collect_report, and Error
/// (cannot_write).
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace talus::report
