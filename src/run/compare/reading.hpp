// SPDX-License-Identifier: MIT
#pragma once
// Sentences on the differences between the methods.

#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Returns sentences that each state a measurement of this case; causes are named only if the numbers show them. The
/// sources are the results of the methods in `run`, and their table, surfaces and exchanged surfaces in `methods`.
std::vector<results::Remark> read_differences(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

/// Returns true if a soil with friction has ψ < φ, for which the bound theorems do not hold.
bool is_nonassociated(const input::Case& data);

}  // namespace talus::run
