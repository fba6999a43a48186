// SPDX-License-Identifier: MIT
#pragma once
// The contract with the page: what a report may hold (web/contract/report.schema.json).

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus::report {

/// What is wrong with `document`, a line each; empty when it keeps the contract.
std::string find_schema_faults(const nlohmann::json& document);

}  // namespace talus::report
