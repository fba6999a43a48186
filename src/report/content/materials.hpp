// SPDX-License-Identifier: MIT
#pragma once
// The soils of a case with their values: as given, divided by the stage's strength factor, and at failure.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/folder.hpp"

namespace talus::report {

/// MaterialRow of web/src/contract/. `factor_of_safety`: what the strength is divided by "at failure".
nlohmann::json list_materials(const ResultFolder& folder, std::optional<double> factor_of_safety);

}  // namespace talus::report
