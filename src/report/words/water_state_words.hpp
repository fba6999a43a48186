// SPDX-License-Identifier: MIT
#pragma once
// Sentences about the water that the methods began with: what leaves where, which sides are closed, what stands on the
// ground.

#include <string>
#include <vector>

#include "report/folder.hpp"

namespace talus::report {

/// None in dry ground.
std::vector<std::string> describe_water_state(const ResultFolder& folder);

}  // namespace talus::report
