// SPDX-License-Identifier: MIT
#pragma once
// Histories, monitors, sections and ground profiles in a report (`Table`, `Section`, `MonitorPaths` in
// web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns `Section[]` of web/src/contract/ from sections/*.csv at the shown times; empty if there are none. A table
/// that cannot be read adds a warning.
nlohmann::json make_sections(const ResultFolder& folder, nlohmann::json& warnings);

/// Returns `MonitorPaths`, the displacement of the monitors from the start of the clock; null if there are none.
nlohmann::json make_paths(const ResultFolder& folder, nlohmann::json& warnings);

/// Returns the tables of the stages, then of the trials with runout. Longer files are thinned to about `most_rows`
/// equally spaced rows with the first and the last, which the title states. A file that cannot be read adds a warning.
nlohmann::json make_tables(const ResultFolder& folder, nlohmann::json& warnings);

inline constexpr std::size_t most_rows = 1000;

}  // namespace talus::report
