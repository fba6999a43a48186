// SPDX-License-Identifier: MIT
#pragma once
// Auxiliary bodies of stages at frozen geometry, with other masses and loads than the body of the case: the
// equalised-mass body, whose small elements do not limit the step, and the drained body of stages with fixed pore
// pressures. Rest or failure of a slope depends on forces only, not on inertia.

#include "run/mpm/stage/stage.hpp"

namespace talus::run {

/// Makes the equalised-mass body of a stage with plan.equalises_mass: points of small elements have more mass, and a
/// load compensates the weight of the addition. If the body comes from a checkpoint, the load continues as before.
template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

/// Index of field 0 of a point in the data of the points; field i is i * lane_width behind it.
template <int D>
std::size_t find_place(const mpm::Points<D>& points, int id) {
  const std::int64_t place = points.place[id];
  return static_cast<std::size_t>(place / lane_width * points.fields * lane_width + place % lane_width);
}

/// Returns the factor of a load that grows with gravity in the stage.
template <int D>
input::TimeTable find_weight_growth(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

/// Copies motion, stress, strain and work of the auxiliary body `stand_in` to the body from which it was made. Masses,
/// water and loads are unchanged.
template <int D>
void copy_from_stand_in(const mpm::Body<D>& stand_in, mpm::Body<D>& body);

/// Runs run_stage() on the auxiliary body. Hooks receive `body`, updated by copy_from_stand_in().
template <int D>
results::StageEnd run_stand_in(mpm::Body<D>& stand_in, mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks);

/// Makes the body of one phase for a stage with fixed pore pressures, with the mass of soil and water together, at the
/// start of the stage or, if state.started, in the state that copy_from_stand_in() left in `wet`. Its stresses are
/// effective stresses. The pore pressures, and external water at the total heads of the start of the stage, are a
/// constant load, as geometry is frozen; it grows with gravity if the plan has a ramp.
template <int D>
mpm::Body<D> make_drained_body(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state);

/// Largest stable step of that body [s].
template <int D>
mpm::CriticalStep find_drained_critical_step(const mpm::Body<D>& wet, const StagePlan<D>& plan);

/// Runs run_stage() for a wet body with fixed pore pressures. Hooks receive the wet body. Throws Error (wrong_input)
/// for moving geometry.
template <int D>
results::StageEnd run_drained_stage(mpm::Body<D>& wet, const StagePlan<D>& plan, StageState& state,
                                    const StageHooks<D>& hooks);

}  // namespace talus::run
