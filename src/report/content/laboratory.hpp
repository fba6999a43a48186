// SPDX-License-Identifier: MIT
#pragma once
// A calibration of a folder (`Calibration` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace talus::report {

/// Adds what `talus calibrate` found to the document of a report: its section, its findings among the warnings, and
/// its answer before that of the element tests. Nothing when the folder holds no calibration.
void add_calibration(const ResultFolder& folder, nlohmann::json& document);

// Element tests of a folder (`PointTests` in web/src/contract/).

/// Tests, their curves and diagrams; null when the folder has none. Throws Error (wrong_input) when a table is missing
/// or damaged.
nlohmann::json make_point_tests(const ResultFolder& folder);

/// The answer of element tests in words.
std::vector<std::string> format_point_tests(const ResultFolder& folder);

/// The assumptions of element tests, in sentences.
std::vector<std::string> list_point_assumptions();

}  // namespace talus::report
