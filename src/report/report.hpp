// SPDX-License-Identifier: MIT
#pragma once
// The report of a results folder as one self-contained HTML file (docs/manual/report.md).

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// The page's contract (web/src/contract/): the results as they are, and what the report adds to them.
struct Content {
  JsonTree results;   ///< `Results`
  JsonTree document;  ///< `ReportDocument`
  std::vector<PackedText> arrays;
};

/// Collects the report of a run, finished or not, of a study, or of element tests. Throws Error (wrong_input) if
/// `folder` contains no results or a damaged file.
Content collect_report(const std::filesystem::path& folder);

/// Writes `folder`/report.html atomically and returns its path. Throws as collect_report(), and Error (cannot_write).
std::filesystem::path write_report(const std::filesystem::path& folder);

/// Returns the report as JSON, {"report", "results", "arrays": {id: base64}}, for a page that is already open. The run
/// may be in progress, because no file of its folder is written. Throws as collect_report().
std::string write_data(const std::filesystem::path& folder);

}  // namespace talus::report
