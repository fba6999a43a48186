// SPDX-License-Identifier: MIT
#pragma once
// Limit analysis as the referee of limit equilibrium.

#include "input/case/case.hpp"
#include "results/bounds.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// The interval of the soil that methods of slices assume: ψ = φ, tension up to the apex, base and ends of the section
/// fixed. An earthquake is tried in both directions, and the weaker one counts. `start`: a factor near the interval,
/// where there is one. What limit analysis cannot judge is told in `why_not`. Throws Error (interrupted).
results::Referee search_referee_interval(const input::Case& data, std::optional<double> start,
                                         const RunOptions& options);

}  // namespace talus::run
