// SPDX-License-Identifier: MIT
#pragma once
// The τ–σ diagram of a soil in the report.

#include <nlohmann/json_fwd.hpp>

#include "input/case/case.hpp"

namespace talus::report {

/// Samples the shear strength of a soil over the normal stress, up to that under the height of the section. Returns
/// null for a soil without a strength on a plane. Strengths by depth have a line at the top of the section and one at
/// its bottom, strengths by inclination one for each of three planes.
nlohmann::json sample_strength(const input::Case& data, const input::Material& soil);

}  // namespace talus::report
