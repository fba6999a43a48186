// SPDX-License-Identifier: MIT
#pragma once
// Proven bounds in a report: the interval, its meshes, and the fields that prove it.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// `ProvenBounds` of web/src/contract/; null when the run has none. Fields that cannot be read leave out their picture
/// and add a warning.
nlohmann::json make_proven_bounds(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
