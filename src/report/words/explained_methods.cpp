// SPDX-License-Identifier: MIT
#include "report/words/explained_methods.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/content/asked_methods.hpp"
#include "report/content/soil_water.hpp"
#include "report/content/step_choices.hpp"
#include "report/content/water_choices.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

void add_soil_methods(const input::Case& data, json& methods) {
  for (const material::Traits& law : material::Laws::traits) {
    if (std::none_of(data.materials.begin(), data.materials.end(),
                     [&](const auto& named) { return named.second.traits().word == law.word; }))
      continue;
    for (const char* paragraph : law.paragraphs)
      if (paragraph && std::find(methods.begin(), methods.end(), paragraph) == methods.end())
        methods.push_back(paragraph);
  }
}

/// Of a wet case.
void add_water_methods(const input::Case& data, json& methods) {
  const std::vector<WaterPart> parts = list_water_parts(data);
  const auto some = [&](auto holds) { return std::any_of(parts.begin(), parts.end(), holds); };
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool flows = some([](const WaterPart& p) { return p.flows(); });
  const auto is = [&](input::WaterMotion motion) {
    return some([motion](const WaterPart& p) { return p.step.water == motion; });
  };
  add_if(is(input::WaterMotion::flows), "two_phase");
  add_if(is(input::WaterMotion::flows), "water_storage");
  add_if(is(input::WaterMotion::seeps), "seeping");
  methods.push_back("soil_water");
  add_if(some([](const WaterPart& p) { return p.flows() && p.step.pressure_smoothing; }), "pressure_smoothing");
  add_if(flows, "hydraulic_conditions");
  add_if(some([](const WaterPart& p) { return !p.flows(); }), "held_pressures");
  add_if(data.initial.water.pressure == input::InitialPressure::seepage, "steady_seepage");
}

/// Of slices.
void add_slice_methods(const results::RunResult& run, json& methods) {
  using S = SliceMethod;
  methods.push_back("limit_equilibrium");
  if (!run.slices) return;
  const results::SliceResult& slices = *run.slices;
  const auto add = [&](const char* paragraph, auto... wanted) {
    if (std::any_of(slices.methods.begin(), slices.methods.end(), [&](S m) { return ((m == wanted) || ...); }))
      methods.push_back(paragraph);
  };
  add("fellenius", S::fellenius);
  add("bishop", S::bishop);
  add("janbu", S::janbu, S::janbu_corrected);
  add("spencer", S::spencer);
  add("morgenstern_price", S::morgenstern_price, S::morgenstern_price_constant);
  add("force_equilibrium", S::corps_1, S::corps_2, S::lowe_karafiath, S::modified_swedish);
  if (slices.search && slices.search->tried > 0) methods.push_back("slip_search");
  if (slices.drawdown) methods.push_back("rapid_drawdown");
  if (std::any_of(slices.critical.begin(), slices.critical.end(),
                  [](const auto& surface) { return surface.yield_acceleration.has_value(); }))
    methods.push_back("yield_acceleration");
}

}  // namespace

json list_methods(const ResultFolder& folder) {
  const results::RunResult& run = folder.run;
  const StepChoices choices = gather_step_choices(folder.data);
  json methods = json::array();
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  const bool moves_points = asks_for(folder, Method::mpm), by_elements = asks_for(folder, Method::fem);
  if (asks_for(folder, Method::lem)) add_slice_methods(run, methods);
  add_if(by_elements, "finite_elements");
  add_if(by_elements, "finite_element_reduction");
  add_if(asks_for(folder, Method::bounds), "limit_analysis");
  add_if(run.methods && run.methods->partial_factors, "partial_factors");
  if (!moves_points) {
    if (by_elements) add_soil_methods(folder.data, methods);
    return methods;
  }
  methods.push_back("material_point_method");
  methods.push_back("time_step");
  add_if(choices.integrations.contains(input::Integration::mixed), "mixed_integration");
  add_if(choices.integrations.contains(input::Integration::points), "point_integration");
  add_if(choices.smoothings.contains(input::Smoothing::strain), "strain_smoothing");
  add_if(choices.smoothings.contains(input::Smoothing::stable), "stable_smoothing");
  add_if(choices.largest_damping > 0, "local_damping");
  add_if(choices.largest_mass_scaling > 1, "mass_scaling");
  add_soil_methods(folder.data, methods);
  add_if(choices.is_reduction, "strength_reduction");
  add_if(choices.has_curve, "displacement_curve");
  add_if(choices.has_frozen, "frozen_factor");
  add_if(run.runout || (run.runouts && !run.runouts->empty()), "runout");
  if (is_wet(folder)) add_water_methods(folder.data, methods);
  return methods;
}

}  // namespace talus::report
