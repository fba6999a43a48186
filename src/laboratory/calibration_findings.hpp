// SPDX-License-Identifier: MIT
#pragma once
// What to distrust in a calibration, in sentences.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// `unfixed`: directions in the ranges of the parameters along which no curve changes; `freedom`: measured values less
/// free parameters. The most serious comes first.
std::vector<std::string> list_findings(const input::Calibration& calibration, const results::Calibration& result,
                                       const std::vector<std::vector<double>>& unfixed, double freedom);

}  // namespace talus::laboratory
