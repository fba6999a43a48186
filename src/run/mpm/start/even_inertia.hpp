// SPDX-License-Identifier: MIT
#pragma once
// Small elements at frozen geometry: their points are given inertia, so that the step is that of the ordinary ones.
// Where a slope comes to rest, and whether it does, depends on forces only.

#include "run/mpm/stage.hpp"

namespace talus::run {

/// The body of one phase as run_stage() calculates it when plan.equalises_mass: points of small elements have more mass,
/// and a load takes the weight of what was added. On a body that a checkpoint brought, the load goes on as it was.
template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state);

}  // namespace talus::run
