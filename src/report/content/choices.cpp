// SPDX-License-Identifier: MIT
#include "report/content/choices.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::report {

bool asks_for(const ResultFolder& folder, Method method) {
  if (folder.run.methods && !folder.run.methods->asked.empty()) {
    const std::vector<Method>& asked = folder.run.methods->asked;
    return std::find(asked.begin(), asked.end(), method) != asked.end();
  }
  // The echo of the input remains if a run failed before any method gave a result.
  switch (method) {
    case Method::lem:
      return input::uses(folder.data, input::Method::lem);
    case Method::fem:
      return input::uses(folder.data, input::Method::fem);
    case Method::bounds:
      return input::uses(folder.data, input::Method::bounds);
    default:
      return input::uses(folder.data, input::Method::mpm);
  }
}

bool asks_for_others(const ResultFolder& folder) {
  return asks_for(folder, Method::lem) || asks_for(folder, Method::fem) || asks_for(folder, Method::bounds);
}

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

std::vector<WaterPart> list_water_parts(const input::Case& data) {
  std::vector<WaterPart> parts;
  for (const input::Stage& stage : data.stages) parts.push_back({"stage '" + stage.name + "'", stage.step});
  if (const input::StepSettings* curve = find_curve_steps(data)) parts.push_back({"the trials of the curve", *curve});
  if (const input::StepSettings* frozen = find_frozen_steps(data))
    parts.push_back({"the trials at frozen geometry", *frozen});
  return parts;
}

std::string describe_stage_water(const input::StepSettings& step) {
  if (step.water == input::WaterMotion::held) return ", pore pressures held (drained)";
  std::string text;
  text += step.water == input::WaterMotion::seeps ? ", water by Darcy's law with pressures at the nodes"
                                                  : ", grains and water with a velocity each";
  if (step.conductivity_factor != 1) text += fmt::format(", conductivities times {:g}", step.conductivity_factor);
  if (step.water_damping > 0)
    text += fmt::format(", damping of the water {:g}{}", step.water_damping,
                        step.damped_force == input::DampedForce::without_drag ? " without drag" : "");
  if (step.drag == input::Drag::explicit_at_nodes) text += ", explicit drag";
  return text;
}

}  // namespace talus::report
