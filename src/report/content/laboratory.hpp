// SPDX-License-Identifier: MIT
#pragma once
// Element tests and calibration of a results folder in its report.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Adds a calibration to the document of a report: its warnings, and its answer before that of the element
/// tests. Does nothing if the folder contains no calibration.
void add_calibration(const ResultFolder& folder, nlohmann::json& document);

/// Returns the columns of each test that its diagrams need, `ReportDocument.point_columns` of web/src/contract/. Throws
/// Error (wrong_input) if a table is missing or damaged.
nlohmann::json read_point_columns(const ResultFolder& folder);

/// Returns the sentences of the answer on the element tests.
std::vector<std::string> format_point_tests(const ResultFolder& folder);

/// Returns the assumptions of the element tests as sentences.
std::vector<std::string> list_point_assumptions();

}  // namespace talus::report
