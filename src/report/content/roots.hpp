#pragma once
// Sentences about [[roots]] and rooted soils.

#include <string>
#include <vector>

#include "report/folder.hpp"

namespace talus::report {

/// What the numbers of rooted soils rest on; nothing for a case without.
std::vector<std::string> list_root_assumptions(const ResultFolder& folder);

}  // namespace talus::report
