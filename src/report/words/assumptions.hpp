// SPDX-License-Identifier: MIT
#pragma once
// Assumptions and limits of a run, as sentences derived from its case and its results; and the paragraphs of the
// methods section that apply to it (`Method` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns the paragraphs that apply, in reading order.
nlohmann::json list_methods(const ResultFolder& folder);

/// Returns the sentences that apply, the most general first.
nlohmann::json list_assumptions(const ResultFolder& folder);

}  // namespace talus::report
