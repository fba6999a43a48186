// SPDX-License-Identifier: MIT
#pragma once
// The frames of a run as sequences: its stages, the trials of the curve, each runout.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

nlohmann::json pack_sequences(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
