// SPDX-License-Identifier: MIT
#pragma once
// The title block, provenance and timing.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Project, Provenance and Timing of web/src/contract/.
nlohmann::json make_project(const results::RunResult& run);
nlohmann::json make_provenance(const ResultFolder& folder);
nlohmann::json make_timing(const results::RunResult& run);

}  // namespace talus::report
