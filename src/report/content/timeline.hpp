// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time (`Timeline` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/pack/pack.hpp"
#include "report/report.hpp"

namespace talus::report {

/// Null for a run without a timeline. What cannot be drawn goes to `warnings`.
nlohmann::json make_timeline(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
