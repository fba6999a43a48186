// SPDX-License-Identifier: MIT
#pragma once
// Sentences about pore water: for the answer of a report, and its assumptions.

#include <string>
#include <vector>

#include "report/folder.hpp"

namespace talus::report {

/// What the results say of pore water; none where the ground is dry.
std::vector<std::string> describe_water(const ResultFolder& folder);

/// The assumptions of a wet case and their limits; none where the ground is dry.
std::vector<std::string> list_water_assumptions(const ResultFolder& folder);

}  // namespace talus::report
