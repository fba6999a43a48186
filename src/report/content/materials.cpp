// SPDX-License-Identifier: MIT
#include "report/content/materials.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/content/properties.hpp"
#include "report/content/soil_water.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Whether Poisson's ratio is known: slices alone do not ask for it.
bool has_poisson_ratio(const input::Case& data, const input::Material& soil) {
  if (!material::needs<material::PoissonInput>(soil.model)) return false;
  return soil.poisson_ratio != 0 || input::uses(data, input::Method::fem) || input::uses(data, input::Method::mpm) ||
         !data.tests.empty();
}

void add_weights(const ResultFolder& folder, const input::Material& soil, Properties& properties) {
  const double gravity = folder.data.gravity.acceleration;
  const auto porosity = find_porosity(soil);
  const auto& unit_weight = soil.slices.unit_weight;
  const bool has_grains = soil.grain_density > 0 && porosity;
  const ShownUnit weight = read_units(folder.run).unit_weight;
  // A unit weight stands for both.
  if (!unit_weight) {
    if (soil.grain_density > 0)
      properties.add("grain_density", "density of the grains", "ρ_s", {"kg/m³", 1}, soil.grain_density);
    properties.add("porosity", "porosity", "n", {"-", 1}, porosity);
  }
  if (porosity && (soil.given_void_ratio || material::needs<material::Preconsolidation>(soil.model)))
    properties.add("void_ratio", "void ratio at the start", "e₀", {"-", 1},
                   soil.given_void_ratio.value_or(soil.void_ratio()));
  if (unit_weight) {
    properties.add("unit_weight", "unit weight above the water table", "γ", weight, unit_weight);
    properties.add("saturated_unit_weight", "unit weight below the water table", "γ_sat", weight,
                   soil.slices.saturated_unit_weight);
  } else if (has_grains) {
    properties.add("unit_weight", "unit weight (dry)", "γ", weight, soil.density() * gravity);
  }
  if (has_grains && soil.water.is_wet()) properties.add_wet_weights(folder, soil);
}

Properties list_properties(const ResultFolder& folder, const input::Material& soil, std::optional<double> stage_factor,
                           std::optional<double> factor_of_safety) {
  const ShownUnits units = read_units(folder.run);
  Properties properties(units, stage_factor, factor_of_safety);
  add_weights(folder, soil, properties);
  if (soil.young_modulus > 0)
    properties.add("young_modulus", "Young's modulus", "E", units.stiffness, soil.young_modulus);
  if (has_poisson_ratio(folder.data, soil))
    properties.add("poisson_ratio", "Poisson's ratio", "ν", {"-", 1}, soil.poisson_ratio);
  properties.add(material::list_properties(soil.model, soil));
  if (const double ratio = soil.slices.pore_pressure_ratio; ratio > 0)
    properties.add("pore_pressure_ratio", "pore pressure over the weight above", "r_u", {"-", 1}, ratio);
  if (soil.slices.suction_strength == input::SuctionStrength::phi_b)
    properties.add("phi_b", "angle of the strength from suction", "φ_b", {"°", degree}, soil.slices.phi_b);
  properties.add_roots(folder.data.roots, soil);
  return properties;
}

}  // namespace

json list_materials(const ResultFolder& folder, std::optional<double> factor_of_safety) {
  json rows = json::array();
  const input::Case& data = folder.data;
  std::optional<double> stage_factor;
  if (!data.stages.empty()) stage_factor = data.stages.back().strength_factor;
  if (stage_factor == 1.0) stage_factor.reset();
  int index = 0;  // points carry the number of their material in the order of the names
  for (const auto& [name, soil] : data.materials) {
    json regions = json::array();
    for (const auto& [region, material] : data.regions)
      if (material == name) regions.push_back(region);
    json row{{"name", name},
             {"index", index++},
             {"model", material::describe_model(soil.model, soil)},
             {"regions", regions},
             {"properties", list_properties(folder, soil, stage_factor, factor_of_safety).list()}};
    if (json water = describe_soil_water(folder, soil.water); !water.is_null()) row["water"] = std::move(water);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace talus::report
