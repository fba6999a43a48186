// SPDX-License-Identifier: MIT
#pragma once
// Methods of slices in a report: critical surfaces with their slices, every trial circle, the search.

#include <nlohmann/json_fwd.hpp>

#include "report/pack/pack.hpp"
#include "report/report.hpp"

namespace talus::report {

/// `Slices` of web/src/contract/; null when the run has none. Trials that cannot be read are left out with a warning.
nlohmann::json make_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

// Strength reduction by finite elements in a report: trials, factors, the fields at failure.

/// `FiniteElements` of web/src/contract/; null when the run has none. Fields that cannot be read leave out
/// their picture and add a warning.
nlohmann::json make_finite_elements(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

// Proven bounds in a report: the interval, its meshes, and the fields that prove it.

/// `ProvenBounds` of web/src/contract/; null when the run has none. Fields that cannot be read leave out their picture
/// and add a warning.
nlohmann::json make_proven_bounds(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
