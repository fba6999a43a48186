// SPDX-License-Identifier: MIT
#pragma once
// Results of LEM, FEM and limit analysis in a report: critical surfaces with their slices and trial circles, strength
// reduction with the fields at failure, and proven bounds with their fields.

#include <nlohmann/json_fwd.hpp>

#include "report/pack/pack.hpp"
#include "report/report.hpp"

namespace talus::report {

/// Returns `Slices` of web/src/contract/; null without LEM. Trials that cannot be read are omitted with a warning.
nlohmann::json make_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

/// Returns `FiniteElements` of web/src/contract/; null without FEM. If the fields cannot be read, their picture is
/// omitted with a warning.
nlohmann::json make_finite_elements(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

/// Returns `ProvenBounds` of web/src/contract/; null without limit analysis. If the fields cannot be read, their
/// picture is omitted with a warning.
nlohmann::json make_proven_bounds(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
