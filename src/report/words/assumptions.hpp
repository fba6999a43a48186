// SPDX-License-Identifier: MIT
#pragma once
// The assumptions of a run and their limits, as sentences derived from its case and its results.

#include <nlohmann/json_fwd.hpp>

#include "report/report.hpp"

namespace talus::report {

// Which paragraphs of the methods section apply to a run (`Method` in web/src/contract/).

/// In the order in which they are read.
nlohmann::json list_methods(const ResultFolder& folder);

/// The sentences that apply, the ones that concern every reader first.
nlohmann::json list_assumptions(const ResultFolder& folder);

}  // namespace talus::report
