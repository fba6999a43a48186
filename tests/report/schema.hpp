// SPDX-License-Identifier: MIT
#pragma once
// Validation of a report against the contract of the page: web/contract/report.schema.json and results.schema.json.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report_page.hpp"

namespace talus::report {

/// Returns the faults of a document, or of the document and the results of a page, a line each; empty if there are
/// none.
std::string find_schema_faults(const nlohmann::json& document);
std::string find_schema_faults(const ReadPage& page);

}  // namespace talus::report
