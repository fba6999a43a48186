// SPDX-License-Identifier: MIT
#pragma once
// Sentences on pore water: results for the answer of a report, assumptions, and the initial state with its seepage
// exits, closed sides and ponded water.

#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns the sentences on the results; empty if the ground is dry.
std::vector<std::string> describe_water(const ResultFolder& folder);

/// Returns the assumptions of a wet case and their limits; empty if the ground is dry.
std::vector<std::string> list_water_assumptions(const ResultFolder& folder);

/// Returns the sentences on the initial state of the pore water; empty if the ground is dry.
std::vector<std::string> describe_water_state(const ResultFolder& folder);

}  // namespace talus::report
