// SPDX-License-Identifier: MIT
#pragma once
// The assumptions of a run and their limits, as sentences derived from its case and its results.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// The sentences that apply, the ones that concern every reader first.
nlohmann::json list_assumptions(const ResultFolder& folder);

}  // namespace talus::report
