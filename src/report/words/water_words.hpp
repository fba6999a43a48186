#pragma once
// Sentences about pore water: for the answer of a report, and what its numbers rest on.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::report {

/// What the results say of pore water; none where the ground is dry.
std::vector<std::string> tell_water(const nlohmann::json& summary);

/// What a wet case assumes, and where that ends; none where the ground is dry.
std::vector<std::string> list_water_assumptions(const nlohmann::json& summary);

}  // namespace talus::report
