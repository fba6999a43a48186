// SPDX-License-Identifier: MIT
#pragma once
// The displacement curve of a run (`Curve` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// The curve of a finished run, else from what finished trials left in the folder; null when there is none.
nlohmann::json make_curve(const ResultFolder& folder);

}  // namespace talus::report
