// SPDX-License-Identifier: MIT
#include "report/content/step_choices.hpp"

#include <algorithm>

namespace talus::report {
namespace {

bool reduces_strength(const input::Case& data) {
  return data.analysis == input::AnalysisKind::strength_reduction;
}

}  // namespace

const input::StepSettings* find_curve_steps(const input::Case& data) {
  const input::DisplacementCurve& curve = data.strength_reduction.curve;
  return reduces_strength(data) && curve.enabled ? &curve.step_settings : nullptr;
}

const input::StepSettings* find_frozen_steps(const input::Case& data) {
  const input::FrozenFactor& frozen = data.strength_reduction.frozen;
  return reduces_strength(data) && frozen.enabled ? &frozen.step_settings : nullptr;
}

StepChoices gather_step_choices(const input::Case& data) {
  StepChoices choices;
  const auto add = [&](const input::StepSettings& step) {
    choices.integrations.insert(step.integration);
    choices.smoothings.insert(step.smoothing);
    choices.largest_damping = std::max(choices.largest_damping, step.damping);
    choices.largest_mass_scaling = std::max(choices.largest_mass_scaling, step.mass_scaling);
  };
  for (const input::Stage& stage : data.stages) {
    add(stage.step);
    choices.stages_are_smoothed = stage.step.smoothing != input::Smoothing::none;
  }
  choices.is_reduction = reduces_strength(data);
  if (const input::StepSettings* curve = find_curve_steps(data)) {
    choices.has_curve = true;
    choices.curve_is_smoothed = curve->smoothing != input::Smoothing::none;
    add(*curve);
  }
  if (const input::StepSettings* frozen = find_frozen_steps(data)) {
    choices.has_frozen = true;
    add(*frozen);
  }
  return choices;
}

}  // namespace talus::report
