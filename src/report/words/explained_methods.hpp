// SPDX-License-Identifier: MIT
#pragma once
// Which paragraphs of the methods section apply to a run (`Method` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// In the order in which they are read.
nlohmann::json list_methods(const ResultFolder& folder);

}  // namespace talus::report
