// SPDX-License-Identifier: MIT
#pragma once
// Warnings on factors that lie far apart: of circles and polylines, of the methods, of the criteria of one method.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The most important first; each names the factors, their likely cause, and what to do. `methods`: those of `run`.
std::vector<std::string> warn_of_disagreement(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

// Sentences on the referee of limit equilibrium.

/// Sentences on the proven interval and on the factors outside it; none without limit equilibrium. `governing`: the
/// factor of the surface that governs.
std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing);

}  // namespace talus::run
