// SPDX-License-Identifier: MIT
#pragma once
// One trial of the strength reduction: from a saved state, with reduced strength, for a window of time.

#include "run/mpm/stage/stage.hpp"

namespace talus::run {

/// Prepares a body for a trial: reduced strength (3.14–3.15), displacements from zero; time and work continue.
template <int D>
mpm::Body<D> start_trial(const mpm::Body<D>& state, const input::Case& data, double factor);

/// Runs the stage `plan` on a body from start_trial and returns its outcome. The body is left at the end of the trial.
template <int D>
results::Trial run_trial(mpm::Body<D>& body, double factor, const StagePlan<D>& plan, StageState& state,
                         const StageHooks<D>& hooks = {});

}  // namespace talus::run
