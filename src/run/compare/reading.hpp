// SPDX-License-Identifier: MIT
#pragma once
// Sentences on the differences between the methods.

#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Each sentence states what was measured in this case; causes are named only where the numbers show them. From the
/// results of the methods in `run` and from their table, surfaces and surfaces handed over in `methods`.
std::vector<results::Remark> read_differences(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

/// True where a soil with friction has ψ < φ, for which limit analysis proves nothing.
bool is_nonassociated(const input::Case& data);

}  // namespace talus::run
