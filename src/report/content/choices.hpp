// SPDX-License-Identifier: MIT
#pragma once
// Numerical choices of a case that the report describes: its methods, the step settings of its stages and trials, and
// the pore-water formulation of each of them.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns true if the case requests `method`. Folders whose case names no method are MPM results.
bool asks_for(const ResultFolder& folder, Method method);

/// Returns true if the case requests other methods than MPM.
bool asks_for_others(const ResultFolder& folder);

/// Return the step settings of the trials of the displacement curve and of the frozen factor; nullptr if the case does
/// not run them.
const input::StepSettings* find_curve_steps(const input::Case& data);
const input::StepSettings* find_frozen_steps(const input::Case& data);

/// Step settings of the stages and of the trials that the case runs.
struct StepChoices {
  std::set<input::Integration> integrations;
  std::set<input::Smoothing> smoothings;
  double largest_damping = 0, largest_mass_scaling = 1;
  bool has_curve = false, has_frozen = false;
  bool is_reduction = false;         ///< analysis.kind is strength_reduction
  bool curve_is_smoothed = false;    ///< the trials of the curve use an anti-locking smoothing
  bool stages_are_smoothed = false;  ///< the last stage uses an anti-locking smoothing
};

StepChoices gather_step_choices(const input::Case& data);

/// A stage, or the trials of one search, of a wet case.
struct WaterPart {
  std::string name;  ///< "stage 'gravity'", "the trials of the curve"
  input::StepSettings step;

  bool flows() const { return input::moves(step.water); }
  /// Returns true for the two-velocity formulation.
  bool has_inertia() const { return step.water == input::WaterMotion::flows; }
};

/// Returns the parts that the case runs, stages first.
std::vector<WaterPart> list_water_parts(const input::Case& data);

/// Returns the clause on pore water in the description of a stage, with a leading comma.
std::string describe_stage_water(const input::StepSettings& step);

}  // namespace talus::report
