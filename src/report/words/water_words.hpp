// SPDX-License-Identifier: MIT
#pragma once
// Sentences about pore water: for the answer of a report, and its assumptions.

#include <string>
#include <vector>

#include "report/report.hpp"

namespace talus::report {

/// What the results say of pore water; none where the ground is dry.
std::vector<std::string> describe_water(const ResultFolder& folder);

/// The assumptions of a wet case and their limits; none where the ground is dry.
std::vector<std::string> list_water_assumptions(const ResultFolder& folder);

// Sentences about the water that the methods began with: what leaves where, which sides are closed, what stands on the
// ground.

/// None in dry ground.
std::vector<std::string> describe_water_state(const ResultFolder& folder);

}  // namespace talus::report
