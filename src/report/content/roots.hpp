// SPDX-License-Identifier: MIT
#pragma once
// Sentences about [[roots]] and rooted soils.

#include <string>
#include <vector>

#include "report/folder.hpp"

namespace talus::report {

/// The assumptions on rooted soils; nothing for a case without.
std::vector<std::string> list_root_assumptions(const ResultFolder& folder);

}  // namespace talus::report
