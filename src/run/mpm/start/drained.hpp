// SPDX-License-Identifier: MIT
#pragma once
// Stages with held pore pressures: the wet body as one of a single phase, as heavy as soil and water together, on which
// the pressures act as constant forces. Geometry is frozen, so neither pressures nor forces change.

#include "run/mpm/stage.hpp"

namespace talus::run {

/// The body of one phase at the start of the stage or, when state.started, as copy_from_stand_in() left it in `wet`.
/// Its stresses are the effective ones; the pore pressures, and outer water below the total heads of the time at the
/// start of the stage, are a load that grows with gravity where the plan has a ramp.
template <int D>
mpm::Body<D> make_drained_body(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state);

/// Largest stable step of that body [s].
template <int D>
mpm::CriticalStep find_drained_critical_step(const mpm::Body<D>& wet, const StagePlan<D>& plan);

/// run_stage() for a wet body whose pressures are held. Hooks receive the wet body. Throws Error (wrong_input) for
/// moving geometry.
template <int D>
results::StageEnd run_drained_stage(mpm::Body<D>& wet, const StagePlan<D>& plan, StageState& state,
                                    const StageHooks<D>& hooks);

}  // namespace talus::run
