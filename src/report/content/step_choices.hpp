// SPDX-License-Identifier: MIT
#pragma once
// How a case calculates its stages and trials.

#include <set>

#include "input/case/case.hpp"

namespace talus::report {

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

}  // namespace talus::report
