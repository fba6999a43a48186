// SPDX-License-Identifier: MIT
#pragma once
// Auxiliary bodies of stages at frozen geometry, with other masses and loads than the body of the case: the
// equalised-mass body, whose small elements do not limit the step, and the drained body of stages with fixed pore
// pressures. Rest or failure of a slope depends on forces only, not on inertia.

#include "mpm/solver/step.hpp"
#include "run/mpm/stage/plan.hpp"

namespace talus::run {

/// Makes the equalised-mass body of a stage with plan.equalises_mass: points of small elements have more mass, and a
/// load compensates the weight of the addition. If the body comes from a checkpoint, the load continues as before.
template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

/// Makes the body of one phase for a stage with fixed pore pressures, with the mass of soil and water together, at the
/// start of the stage or, if state.started, in the state that copy_from_auxiliary() left in `wet`. Its stresses are
/// effective stresses. The pore pressures, and external water at the total heads of the start of the stage, are a
/// constant load, as geometry is frozen; it grows with gravity if the plan has a ramp. Throws Error (wrong_input) for
/// moving geometry.
template <int D>
mpm::Body<D> make_drained_body(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state);

/// Copies motion, stress, strain and work of the auxiliary body to the body from which it was made. Masses, water and
/// loads are unchanged.
template <int D>
void copy_from_auxiliary(const mpm::Body<D>& auxiliary, mpm::Body<D>& body);

/// Returns true if the stage steps the drained body, or the equalised-mass body, in place of `body`.
template <int D>
bool is_drained(const mpm::Body<D>& body, const StagePlan<D>& plan);
template <int D>
bool equalises_mass(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// Largest stable step [s] of the plan for Courant number 1, and the element that limits it.
template <int D>
mpm::CriticalStep find_critical_step(const mpm::Body<D>& body, const StagePlan<D>& plan);

}  // namespace talus::run
