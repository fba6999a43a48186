// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a run: properties, initial state, conditions and budget (`Water` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Null where the ground is dry.
nlohmann::json make_water(const ResultFolder& folder);

/// Water tables at the start [m], as `Model.water` lists them: of the steady seepage, or of the case.
nlohmann::json list_water_tables(const ResultFolder& folder);

}  // namespace talus::report
