#pragma once
// Histories and ground profiles as columns (`Table` in web/src/contract.ts).

#include <nlohmann/json.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Tables of the stages, then of the trials that run out. Of longer files about `most_rows` rows are taken, evenly
/// spread, the first and the last among them; the title says so.
nlohmann::json make_tables(const ResultFolder& folder);

inline constexpr std::size_t most_rows = 1000;

}  // namespace talus::report
