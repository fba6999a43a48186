// SPDX-License-Identifier: MIT
#pragma once
// Histories and ground profiles as columns (`Table` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Tables of the stages, then of the trials that run out. Of longer files about `most_rows` rows are taken, evenly
/// spread, the first and the last among them; the title says so. If a file cannot be read, the report lacks its
/// table, and `warnings` gets a sentence.
nlohmann::json make_tables(const ResultFolder& folder, nlohmann::json& warnings);

inline constexpr std::size_t most_rows = 1000;

}  // namespace talus::report
