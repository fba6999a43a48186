// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a run: properties, initial state, conditions and budget (`Water` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Null where the ground is dry.
nlohmann::json make_water(const ResultFolder& folder);

}  // namespace talus::report
