// SPDX-License-Identifier: MIT
#pragma once
// Histories and ground profiles as columns (`Table` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/report.hpp"

namespace talus::report {

// The sections of a case and what its monitors did, as the report shows them.

/// `Section[]` of web/src/contract/ from sections/*.csv, at the times that are shown; empty when there are none. A
/// table that cannot be read adds a warning.
nlohmann::json make_sections(const ResultFolder& folder, nlohmann::json& warnings);

/// `MonitorPaths`: the displacement of the monitors from the start of the clock on; null when there are none.
nlohmann::json make_paths(const ResultFolder& folder, nlohmann::json& warnings);

/// Tables of the stages, then of the trials that run out. Of longer files about `most_rows` rows are taken, evenly
/// spread, the first and the last among them; the title says so. If a file cannot be read, the report lacks its
/// table, and `warnings` gets a sentence.
nlohmann::json make_tables(const ResultFolder& folder, nlohmann::json& warnings);

inline constexpr std::size_t most_rows = 1000;

}  // namespace talus::report
