// SPDX-License-Identifier: MIT
#pragma once
// A calibration of a folder (`Calibration` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>

#include "report/folder.hpp"

namespace talus::report {

/// Adds what `talus calibrate` found to the document of a report: its section, its findings among the warnings, and
/// its answer before that of the element tests. Nothing when the folder holds no calibration.
void add_calibration(const ResultFolder& folder, nlohmann::json& document);

}  // namespace talus::report
