// SPDX-License-Identifier: MIT
#include "report/content/water_choices.hpp"

#include <fmt/format.h>

#include "report/content/step_choices.hpp"

namespace talus::report {

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
