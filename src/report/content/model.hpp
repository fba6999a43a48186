// SPDX-License-Identifier: MIT
#pragma once
// The calculation model as the report shows it (`Model` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// `factor_of_safety` is what the strength of the materials is divided by "at failure". The mesh is packed when the
/// folder holds one that is small enough to be drawn.
nlohmann::json make_model(const ResultFolder& folder, std::optional<double> factor_of_safety, Packer& packer);

}  // namespace talus::report
