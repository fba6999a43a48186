// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety of a case by every criterion that it asks for.

#include <vector>

#include "results/run.hpp"
#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

/// Runs what [strength_reduction] asks for and puts curve, criteria, runouts and the frozen factor into `run`.
/// `state` is the body after the stages; it is not needed, and may be empty, when the curve is not asked for.
template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     results::RunResult& run, std::vector<std::string>& warnings);

}  // namespace talus::run
