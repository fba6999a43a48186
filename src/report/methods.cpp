#include "report/methods.hpp"

#include <algorithm>

#include "report/look_up.hpp"
#include "report/soil_water.hpp"
#include "report/step_choices.hpp"
#include "report/water_choices.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

void add_soil_methods(const json& summary, json& methods) {
  const json* materials = find(summary, {"input", "materials"});
  if (materials == nullptr) return;
  const auto some = [&](auto... models) {
    return std::any_of(materials->begin(), materials->end(),
                       [&](const json& m) { return ((get_word(m, "model") == models) || ...); });
  };
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  add_if(some("mohr_coulomb", "rooted_mohr_coulomb"), "mohr_coulomb");
  add_if(some("rooted_mohr_coulomb"), "root_cohesion");
  add_if(some("modified_cam_clay", "rooted_cam_clay"), "modified_cam_clay");
  add_if(some("rooted_cam_clay"), "rooted_cam_clay");
  add_if(some("linear_elastic"), "linear_elastic");
  add_if(some("external"), "external_model");
}

/// Of a wet case.
void add_water_methods(const json& summary, json& methods) {
  const std::vector<WaterPart> parts = list_water_parts(summary);
  const auto some = [&](auto holds) { return std::any_of(parts.begin(), parts.end(), holds); };
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool flows = some([](const WaterPart& p) { return p.flows; });
  add_if(flows, "two_phase");
  add_if(flows, "water_storage");
  methods.push_back("soil_water");
  add_if(some([](const WaterPart& p) { return p.flows && p.smooths_pressure; }), "pressure_smoothing");
  add_if(flows, "hydraulic_conditions");
  add_if(some([](const WaterPart& p) { return !p.flows; }), "held_pressures");
  const json* initial = find(summary, {"input", "initial"});
  add_if(initial != nullptr && get_word(*initial, "pore_pressure") == "seepage", "steady_seepage");
}

}  // namespace

json list_methods(const json& summary) {
  const StepChoices choices = gather_step_choices(summary);
  json methods{"material_point_method", "time_step"};
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  add_if(choices.integrations.contains("mixed"), "mixed_integration");
  add_if(choices.integrations.contains("points"), "point_integration");
  add_if(choices.smoothings.contains("strain"), "strain_smoothing");
  add_if(choices.smoothings.contains("stable"), "stable_smoothing");
  add_if(choices.largest_damping > 0, "local_damping");
  add_if(choices.largest_mass_scaling > 1, "mass_scaling");
  add_soil_methods(summary, methods);
  add_if(choices.is_reduction, "strength_reduction");
  add_if(choices.has_curve, "displacement_curve");
  add_if(choices.has_frozen, "frozen_factor");
  add_if(find(summary, {"runout"}) != nullptr || !find_list(summary, {"runouts"}).empty(), "runout");
  if (is_wet(summary)) add_water_methods(summary, methods);
  return methods;
}

}  // namespace talus::report
