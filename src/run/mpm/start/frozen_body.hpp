// SPDX-License-Identifier: MIT
#pragma once
// Small elements at frozen geometry: their points are given inertia, so that the step is that of the ordinary ones.
// Where a slope comes to rest, and whether it does, depends on forces only.

#include "run/mpm/stage.hpp"

namespace talus::run {

/// The body of one phase as run_stage() calculates it when plan.equalises_mass: points of small elements have more
/// mass, and a load takes the weight of what was added. On a body that a checkpoint brought, the load goes on as it
/// was.
template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

// Stages at frozen geometry that are calculated on a body made for them, with other masses and loads, and read back
// into the body that the caller has.

/// Place of field 0 of a point in the points' data; field i is i * lane_width behind it.
template <int D>
std::size_t find_place(const mpm::Points<D>& points, int id) {
  const std::int64_t place = points.place[id];
  return static_cast<std::size_t>(place / lane_width * points.fields * lane_width + place % lane_width);
}

/// The factor of a load that grows with the weight of the stage.
template <int D>
input::TimeTable find_weight_growth(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

/// Motion, stress, strain and work of `stand_in` into the body it was made of. Masses, water and loads stay as they
/// are.
template <int D>
void copy_from_stand_in(const mpm::Body<D>& stand_in, mpm::Body<D>& body);

/// run_stage() on the stand-in. Hooks receive `body`, brought up to date by copy_from_stand_in().
template <int D>
results::StageEnd run_stand_in(mpm::Body<D>& stand_in, mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks);

// Stages with held pore pressures: the wet body as one of a single phase, as heavy as soil and water together, on which
// the pressures act as constant forces. Geometry is frozen, so neither pressures nor forces change.

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
