#pragma once
// What the differences between the methods say, in the sentences an engineer would write.

#include <nlohmann/json.hpp>

#include "input/case/case.hpp"

namespace talus::run {

/// Each sentence states what was measured in this case; causes are named only where the numbers show them. `methods`:
/// table, surfaces and handed surfaces of summary.json.
nlohmann::json read_differences(const input::Case& data, const nlohmann::json& summary, const nlohmann::json& methods);

}  // namespace talus::run
