// SPDX-License-Identifier: MIT
#pragma once
// A stage on several ranks: each advances its share of the body, and rank 0 records the whole one.

#include "run/mpm/stage.hpp"

namespace talus::run {

/// run_stage() of a body that every rank has as a whole, and has again at the end. Hooks are those of rank 0. What a
/// hook throws there is thrown on all ranks.
template <int D>
results::StageEnd run_on_ranks(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks);

}  // namespace talus::run
