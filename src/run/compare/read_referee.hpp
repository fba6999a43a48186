// SPDX-License-Identifier: MIT
#pragma once
// Sentences on the referee of limit equilibrium.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Sentences on the proven interval and on the factors outside it; none without limit equilibrium. `governing`: the
/// factor of the surface that governs.
std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing);

}  // namespace talus::run
