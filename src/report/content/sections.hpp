// SPDX-License-Identifier: MIT
#pragma once
// The sections of a case and what its monitors did, as the report shows them.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// `Section[]` of web/src/contract/ from sections/*.csv, at the times that are shown; empty when there are none. A
/// table that cannot be read adds a warning.
nlohmann::json make_sections(const ResultFolder& folder, nlohmann::json& warnings);

/// `MonitorPaths`: the displacement of the monitors from the start of the clock on; null when there are none.
nlohmann::json make_paths(const ResultFolder& folder, nlohmann::json& warnings);

}  // namespace talus::report
