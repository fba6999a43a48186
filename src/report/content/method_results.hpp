// SPDX-License-Identifier: MIT
#pragma once
// Arrays of LEM, FEM and limit analysis in a report: trial circles, the fields at failure, the fields of limit
// analysis.

#include <nlohmann/json_fwd.hpp>

#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// Return what the report adds to the results of a method: `Slices`, `ElementsDrawn` and `BoundsDrawn` of
/// web/src/contract/; null without the method, and where there is nothing to draw. Files that cannot be read are
/// omitted with a warning.
nlohmann::json pack_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
nlohmann::json pack_finite_elements(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
nlohmann::json pack_proven_bounds(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
