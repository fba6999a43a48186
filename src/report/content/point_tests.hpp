#pragma once
// Element tests of a folder (`PointTests` in web/src/contract/).

#include <nlohmann/json.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Tests, their curves and diagrams; null when the folder has none. Throws Error (wrong_input) when a table is missing
/// or damaged.
nlohmann::json make_point_tests(const ResultFolder& folder);

/// `Answer` of a folder that holds element tests alone.
nlohmann::json make_point_answer(const ResultFolder& folder);

/// What element tests rest on, in sentences.
nlohmann::json list_point_assumptions();

}  // namespace talus::report
