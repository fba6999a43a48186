// SPDX-License-Identifier: MIT
#pragma once
// Warnings on factors that lie far apart: of circles and polylines, of the methods, of the criteria of one method.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The most important first; each names the factors, their likely cause, and what to do. `methods`: those of `run`.
std::vector<std::string> warn_of_disagreement(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

}  // namespace talus::run
