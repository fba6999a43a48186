#include "report/content/water_choices.hpp"

#include <fmt/format.h>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

WaterPart read_part(const json& step, std::string name) {
  WaterPart part;
  part.name = std::move(name);
  part.flows = get_word(step, "water", "flows") != "held";
  part.is_frozen_geometry = get_word(step, "geometry") == "frozen";
  part.conductivity_factor = get_si(step, "conductivity_factor", 1);
  part.mass_scaling = get_si(step, "mass_scaling", 1);
  part.damping = get_si(step, "water_damping", 0);
  part.has_explicit_drag = get_word(step, "drag") == "explicit";
  part.damps_without_drag = get_word(step, "damped_force") == "without_drag";
  part.smooths_pressure = get_flag(step, "pressure_smoothing");
  return part;
}

/// The settings of a search that is on; nullptr otherwise.
const json* find_search(const json& summary, const char* search) {
  const json* analysis = find(summary, {"input", "analysis"});
  if (analysis == nullptr || get_word(*analysis, "kind") != "strength_reduction") return nullptr;
  const json* settings = find(summary, {"input", "strength_reduction", search});
  return settings != nullptr && get_flag(*settings, "enabled") ? settings : nullptr;
}

}  // namespace

std::vector<WaterPart> list_water_parts(const json& summary) {
  std::vector<WaterPart> parts;
  for (const json& stage : find_list(summary, {"input", "stage"}))
    parts.push_back(read_part(stage, "stage '" + get_word(stage, "name") + "'"));
  if (const json* curve = find_search(summary, "curve")) parts.push_back(read_part(*curve, "the trials of the curve"));
  if (const json* frozen = find_search(summary, "frozen"))
    parts.push_back(read_part(*frozen, "the trials at frozen geometry"));
  return parts;
}

std::string find_water_of_trials(const json& summary, const char* search) {
  const json* settings = find_search(summary, search);
  return settings != nullptr ? get_word(*settings, "water", "flows") : "";
}

std::string describe_stage_water(const json& stage) {
  const WaterPart part = read_part(stage, "");
  if (!part.flows) return ", pore pressures held (drained)";
  std::string text;
  if (part.conductivity_factor != 1) text += fmt::format(", conductivities times {:g}", part.conductivity_factor);
  if (part.damping > 0)
    text += fmt::format(", damping of the water {:g}{}", part.damping, part.damps_without_drag ? " without drag" : "");
  if (part.has_explicit_drag) text += ", explicit drag";
  return text;
}

}  // namespace talus::report
