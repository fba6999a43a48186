#include "report/words/explained_methods.hpp"

#include <algorithm>

#include "report/content/asked_methods.hpp"
#include "report/content/soil_water.hpp"
#include "report/content/step_choices.hpp"
#include "report/content/water_choices.hpp"
#include "report/look_up.hpp"

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

/// Of slices.
void add_slice_methods(const json& summary, json& methods) {
  methods.push_back("limit_equilibrium");
  const json& asked = find_list(summary, {"lem", "methods"});
  const auto add = [&](const char* paragraph, auto... names) {
    if (std::any_of(asked.begin(), asked.end(), [&](const json& m) { return ((m == names) || ...); }))
      methods.push_back(paragraph);
  };
  add("fellenius", "fellenius");
  add("bishop", "bishop");
  add("janbu", "janbu", "janbu_corrected");
  add("spencer", "spencer");
  add("morgenstern_price", "morgenstern_price", "morgenstern_price_constant");
  if (get_number(summary, {"lem", "search", "tried"}) > 0) methods.push_back("slip_search");
  for (const json& surface : find_list(summary, {"lem", "critical"}))
    if (find_number(surface, {"yield_acceleration"})) {
      methods.push_back("yield_acceleration");
      break;
    }
}

}  // namespace

json list_methods(const json& summary) {
  const StepChoices choices = gather_step_choices(summary);
  json methods = json::array();
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool moves_points = asks_for(summary, "mpm"), by_elements = asks_for(summary, "fem");
  if (asks_for(summary, "lem")) add_slice_methods(summary, methods);
  add_if(by_elements, "finite_elements");
  add_if(by_elements, "finite_element_reduction");
  add_if(find(summary, {"methods", "partial_factors"}) != nullptr, "partial_factors");
  if (!moves_points) {
    if (by_elements) add_soil_methods(summary, methods);
    return methods;
  }
  methods.push_back("material_point_method");
  methods.push_back("time_step");
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
