// SPDX-License-Identifier: MIT
#pragma once
// Element tests of a folder (`PointTests` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/folder.hpp"

namespace talus::report {

/// Tests, their curves and diagrams; null when the folder has none. Throws Error (wrong_input) when a table is missing
/// or damaged.
nlohmann::json make_point_tests(const ResultFolder& folder);

/// The answer of element tests in words.
std::vector<std::string> format_point_tests(const ResultFolder& folder);

/// The assumptions of element tests, in sentences.
std::vector<std::string> list_point_assumptions();

}  // namespace talus::report
