// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time (`Timeline` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Null for a run without a timeline.
nlohmann::json make_timeline(const ResultFolder& folder);

}  // namespace talus::report
