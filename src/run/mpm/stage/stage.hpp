// SPDX-License-Identifier: MIT
#pragma once
// One stage: the loop over steps with the time step, the output, the check of stability and the rest criterion.

#include "run/mpm/stage/hooks.hpp"

namespace talus::run {

template <int D>
class SteppedBody;

/// Advances the body to the end of the stage. `state` is new or from a checkpoint; the strength of the body must be
/// set. The loop steps the body itself, or the one that SteppedBody makes from it for fixed pore pressures, equalised
/// mass and several ranks, and repeats an unstable stage (Recovery). With plan.helpers rank 0 alone has the body;
/// otherwise every rank has it before and after, and hooks run on rank 0. Throws Error (unstable) and what hooks throw,
/// on all ranks.
template <int D>
results::StageEnd run_stage(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                            const StageHooks<D>& hooks = {});

/// The same for a body that is prepared for its steps.
template <int D>
results::StageEnd advance_stage(SteppedBody<D>& stepped, StageState& state);

}  // namespace talus::run
