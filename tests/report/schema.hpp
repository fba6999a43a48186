// SPDX-License-Identifier: MIT
#pragma once
// Validation of a report against the contract of the page (web/contract/report.schema.json).

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus::report {

/// Returns the faults of `document`, a line each; empty if it keeps the contract.
std::string find_schema_faults(const nlohmann::json& document);

}  // namespace talus::report
