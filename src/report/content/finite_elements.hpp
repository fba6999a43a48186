// SPDX-License-Identifier: MIT
#pragma once
// Strength reduction by finite elements in a report: trials, factors, the fields at failure.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// `FiniteElements` of web/src/contract/; null when the run has none. Fields that cannot be read leave out
/// their picture and add a warning.
nlohmann::json make_finite_elements(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
