#pragma once
// Methods of slices in a report: critical surfaces with their slices, every trial circle, the search.

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// `Slices` of web/src/contract/; null when the run has none. What of the trials cannot be read costs them and
/// adds a warning.
nlohmann::json make_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

}  // namespace talus::report
