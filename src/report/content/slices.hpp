// SPDX-License-Identifier: MIT
#pragma once
// Methods of slices in a report: critical surfaces with their slices, every trial circle, the search.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// `Slices` of web/src/contract/; null when the run has none. Trials that cannot be read are left out with a warning.
nlohmann::json make_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
