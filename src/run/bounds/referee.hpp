// SPDX-License-Identifier: MIT
#pragma once
// Limit analysis as the referee of LEM.

#include "input/case/case.hpp"
#include "results/bounds.hpp"
#include "run/common/run_folder.hpp"

namespace talus::run {

/// Computes the interval of limit analysis under the assumptions of LEM: ψ = φ, tension up to the apex, base and ends
/// of the section fixed. An earthquake is applied in both directions, and the smaller factor counts. `start`: a factor
/// near the interval, if known. `why_not` has the reason if limit analysis does not support the case. Throws Error
/// (interrupted).
results::Referee search_referee_interval(const input::Case& data, std::optional<double> start,
                                         const RunOptions& options);

}  // namespace talus::run
