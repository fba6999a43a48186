// SPDX-License-Identifier: MIT
#pragma once
// Which methods a case asks for: slices, finite elements, material points.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "report/report.hpp"

namespace talus::report {

/// A folder that names no method is one of material points.
bool asks_for(const ResultFolder& folder, Method method);

/// Whether it asks for more than material points.
bool asks_for_others(const ResultFolder& folder);

// How a case calculates its stages and trials.

/// What the trials of a search use; nullptr where the case does not run them.
const input::StepSettings* find_curve_steps(const input::Case& data);
const input::StepSettings* find_frozen_steps(const input::Case& data);

/// What the stages, the curve's trials and the frozen factor's trials use, as far as the case runs them.
struct StepChoices {
  std::set<input::Integration> integrations;
  std::set<input::Smoothing> smoothings;
  double largest_damping = 0, largest_mass_scaling = 1;
  bool has_curve = false, has_frozen = false;
  bool is_reduction = false;         ///< analysis.kind is strength_reduction
  bool curve_is_smoothed = false;    ///< the curve's trials avoid locking
  bool stages_are_smoothed = false;  ///< the last stage does
};

StepChoices gather_step_choices(const input::Case& data);

// How pore water is calculated in the stages and trials of a wet case.

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
