// SPDX-License-Identifier: MIT
#pragma once
// The results of a run by name (`NamedResult` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// The results, without the zeros that a runout without any soil comes to.
nlohmann::json list_named_results(const ResultFolder& folder);

}  // namespace talus::report
