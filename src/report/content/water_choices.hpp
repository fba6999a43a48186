// SPDX-License-Identifier: MIT
#pragma once
// How pore water is calculated in the stages and trials of a wet case.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::report {

/// A stage of the case, or the trials of one search.
struct WaterPart {
  std::string name;  ///< "stage 'gravity'", "the trials of the curve"
  input::StepSettings step;

  bool flows() const { return input::moves(step.water); }
  /// Water has a velocity of its own.
  bool has_inertia() const { return step.water == input::WaterMotion::flows; }
};

/// The parts that are run, stages first.
std::vector<WaterPart> list_water_parts(const input::Case& data);

/// The clause of a stage's description on its pore water, with a comma in front.
std::string describe_stage_water(const input::StepSettings& step);

}  // namespace talus::report
