#include "report/content/materials.hpp"

#include <fmt/format.h>

#include <numbers>

#include "report/content/properties.hpp"
#include "report/content/soil_water.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;

std::string name_model(const json& soil) {
  const std::string model = get_word(soil, "model");
  if (model == "mohr_coulomb") return "Mohr–Coulomb";
  if (model == "rooted_mohr_coulomb") return "Mohr–Coulomb with the cohesion of roots";
  if (model == "modified_cam_clay") return "modified Cam-clay";
  if (model == "rooted_cam_clay") return "rooted Cam-clay";
  if (model == "linear_elastic") return "linear elastic";
  if (model == "external")
    return fmt::format("external: UMAT '{}' of {}", get_word(soil, "symbol", "umat_"), get_word(soil, "library"));
  return model;
}

}  // namespace

json list_materials(const json& summary, std::optional<double> factor_of_safety) {
  json rows = json::array();
  const json* materials = find(summary, {"input", "materials"});
  if (materials == nullptr || !materials->is_object()) return rows;
  const ShownUnits units = read_units(summary);
  const json* regions = find(summary, {"input", "regions"});
  const json& stages = find_list(summary, {"input", "stage"});
  const json* weight = find(summary, {"input", "gravity"});
  const double gravity = weight != nullptr ? get_si(*weight, "acceleration", 9.81) : 9.81;
  std::optional<double> stage_factor;
  if (!stages.empty()) stage_factor = find_si(stages.back(), "strength_factor");
  if (stage_factor == 1.0) stage_factor.reset();

  int index = 0;  // points carry the number of their material in the order of the names
  for (const auto& [name, soil] : materials->items()) {
    json own_regions = json::array();
    if (regions != nullptr)
      for (const auto& [region, material] : regions->items())
        if (get_text(material, {"value"}) == name) own_regions.push_back(region);
    Properties properties(units.stress, stage_factor, factor_of_safety);
    const auto density = find_si(soil, "grain_density"), porosity = find_porosity(soil);
    // A unit weight stands for both.
    if (!find_si(soil, "unit_weight")) {
      properties.add("grain_density", "density of the grains", "ρs", {"kg/m³", 1}, density);
      properties.add("porosity", "porosity", "n", {"-", 1}, porosity);
    }
    if (find_si(soil, "void_ratio") || is_cam_clay(soil))
      properties.add("void_ratio", "void ratio at the start", "e₀", {"-", 1}, find_void_ratio(soil));
    if (const auto given = find_si(soil, "unit_weight")) {
      properties.add("unit_weight", "unit weight above the water table", "γ", {"kN/m³", 1000}, given);
      properties.add("saturated_unit_weight", "unit weight below the water table", "γ_r", {"kN/m³", 1000},
                     find_si(soil, "saturated_unit_weight"));
    } else if (density && porosity)
      properties.add("unit_weight", "unit weight (dry)", "γ", {"kN/m³", 1000}, (1 - *porosity) * *density * gravity);
    const input::PoreWater pore_water = read_pore_water(soil);
    if (density && porosity && pore_water.is_wet())
      properties.add_wet_weights(summary, pore_water, *density, *porosity, gravity);
    properties.add("young_modulus", "Young's modulus", "E", {"MPa", 1e6}, find_si(soil, "young_modulus"));
    properties.add("poisson_ratio", "Poisson's ratio", "ν", {"-", 1}, find_si(soil, "poisson_ratio"));
    if (is_mohr_coulomb(soil)) properties.add_mohr_coulomb(soil);
    if (is_cam_clay(soil)) properties.add_cam_clay(soil);
    if (const double ratio = get_si(soil, "pore_pressure_ratio", 0); ratio > 0)
      properties.add("pore_pressure_ratio", "pore pressure over the weight above", "r_u", {"-", 1}, ratio);
    if (get_word(soil, "suction_strength") == "phi_b")
      properties.add("phi_b", "angle of the strength from suction", "φ_b", {"°", degree}, find_si(soil, "phi_b"));
    if (const double gradient = get_si(soil, "cohesion_gradient", 0); gradient != 0)
      properties.add("cohesion_gradient", "growth of the cohesion with depth", "dc/dz", {"kPa/m", 1000}, gradient);
    properties.add_roots(summary, soil);
    if (get_word(soil, "model") == "external") properties.add_external(soil);
    json row{{"name", name},
             {"index", index++},
             {"model", name_model(soil)},
             {"regions", own_regions},
             {"properties", properties.rows}};
    if (json water = describe_soil_water(summary, soil); !water.is_null()) row["water"] = std::move(water);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace talus::report
