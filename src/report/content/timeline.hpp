// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety over time in a report (`Timeline` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// Returns null for a run without a timeline. Fields that cannot be drawn add a warning.
nlohmann::json make_timeline(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
