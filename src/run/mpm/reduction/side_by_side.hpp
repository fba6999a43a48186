// SPDX-License-Identifier: MIT
#pragma once
// Trials that are calculated at the same time: on threads of one process, or on groups of ranks.

#include <filesystem>
#include <functional>
#include <vector>

#include "results/trial.hpp"

namespace talus::run {

/// How many trials of a body of this size run side by side on `threads` threads of a process, or on the ranks; the rest
/// of them work inside the trials. Small bodies gain nothing from threads inside a step.
int count_parallel_trials(int points, int threads);

/// Returns work(i) for i < count, up to `side_by_side` at once. Of several ranks each group calculates a part of them;
/// then all know all outcomes, and rank 0 has in folder(i) the files that were written there.
std::vector<results::TrialOutcome> run_side_by_side(int count, int side_by_side,
                                                    const std::function<results::TrialOutcome(int)>& work,
                                                    const std::function<std::filesystem::path(int)>& folder = {});

}  // namespace talus::run
