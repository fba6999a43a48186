// SPDX-License-Identifier: MIT
#pragma once
// Forces of bars, walls and struts at the end of a stage of construction, and how far walls have moved.

#include <vector>

#include "fem/solid/solid.hpp"
#include "results/construction.hpp"
#include "run/construction/stage_model.hpp"

namespace talus::run {

/// Returns the forces of the bars and walls of a stage; none without supports.
std::vector<fem::BarForces> list_bar_forces(const StageModel& stage, const fem::SolidState<2>& solid);

/// Returns the results of the supports at the end of a stage. `start`: their forces at its begin. `before`: the stage
/// before, whose deflections the motion in this one is added to; null: they count from the begin of this one.
std::vector<results::ConstructionSupport> make_stage_supports(const StageModel& stage, const fem::SolidState<2>& solid,
                                                              const std::vector<fem::BarForces>& start,
                                                              const results::ConstructionStage* before);

}  // namespace talus::run
