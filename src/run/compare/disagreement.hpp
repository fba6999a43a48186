// SPDX-License-Identifier: MIT
#pragma once
// Warnings on large differences between factors: of circles and polylines, of the methods, and of the criteria of one
// method; and sentences on the referee of LEM.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Returns warnings, the most important first; each names the factors, their likely cause and a remedy. `methods`: the
/// comparison of `run`.
std::vector<std::string> warn_of_disagreement(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

/// Returns sentences on the interval of limit analysis and on LEM factors outside it; empty without LEM. `governing`:
/// the factor of the governing surface.
std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing);

}  // namespace talus::run
