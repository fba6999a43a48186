// SPDX-License-Identifier: MIT
#pragma once
// Stages at frozen geometry that are calculated on a body made for them, with other masses and loads, and read back
// into the body that the caller has.

#include "run/mpm/stage.hpp"

namespace talus::run {

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

}  // namespace talus::run
