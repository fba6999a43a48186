#include "report/materials.hpp"

#include <fmt/format.h>

#include <numbers>

#include "material/mohr_coulomb.hpp"
#include "report/look_up.hpp"
#include "report/soil_water.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// 30° comes back from radians as 29.999999999999996°.
double drop_last_digits(double value) {
  return std::stod(fmt::format("{:.12g}", value));
}

/// Rows of one material.
class Properties {
 public:
  explicit Properties(const ShownUnit& stress) : stress_(stress) {}

  void add(const char* key, const char* title, const char* symbol, const ShownUnit& unit, std::optional<double> value,
           std::optional<double> design = {}, std::optional<double> at_failure = {}) {
    if (!value) return;
    const auto shown = [&](std::optional<double> si) { return si ? json(drop_last_digits(*si / unit.si)) : json(); };
    rows.push_back({{"key", key},
                    {"title", title},
                    {"symbol", symbol},
                    {"unit", unit.name},
                    {"characteristic", shown(value)},
                    {"design", shown(design)},
                    {"at_failure", shown(at_failure)}});
  }

  void add_strength(const json& soil, std::optional<double> stage_factor, std::optional<double> failure_factor) {
    const material::MohrCoulombStrength given{get_si(soil, "cohesion", 0), get_si(soil, "friction_angle", 0),
                                              get_si(soil, "dilatancy_angle", 0), get_si(soil, "tensile_strength", 0)};
    const auto reduce = [&](std::optional<double> factor) {
      return factor ? std::optional(given.reduced(*factor)) : std::nullopt;
    };
    const auto design = reduce(stage_factor), failure = reduce(failure_factor);
    const auto add_one = [&](const char* key, const char* title, const char* symbol, const ShownUnit& unit,
                             double material::MohrCoulombStrength::*value) {
      const auto read = [&](const auto& strength) {
        return strength ? std::optional((*strength).*value) : std::nullopt;
      };
      add(key, title, symbol, unit, given.*value, read(design), read(failure));
    };
    using material::MohrCoulombStrength;
    add_one("cohesion", "cohesion", "c", stress_, &MohrCoulombStrength::cohesion);
    add_one("friction_angle", "angle of internal friction", "φ", {"°", degree}, &MohrCoulombStrength::friction_angle);
    add_one("dilatancy_angle", "angle of dilatancy", "ψ", {"°", degree}, &MohrCoulombStrength::dilatancy_angle);
    add_one("tensile_strength", "tensile strength", "σt", stress_, &MohrCoulombStrength::tensile_strength);
  }

  /// With all pores that fill full of water, and as light as the driest soil of the model.
  void add_wet_weights(const json& summary, const model::PoreWater& soil, double density, double porosity,
                       double gravity) {
    const ShownUnit weight{"kN/m³", 1000};
    const double water = read_water(summary).density;
    const auto weigh = [&](double suction) {
      return ((1 - porosity) * density + porosity * find_saturation(soil, suction) * water) * gravity;
    };
    add("unit_weight_saturated", "unit weight (below the water table)", "γ_sat", weight, weigh(0));
    const auto largest = find_largest_suction(summary);
    if (!largest || weigh(*largest) == weigh(0)) return;
    const std::string title =
        fmt::format("unit weight (at the largest suction, S = {:.2f})", find_saturation(soil, *largest));
    add("unit_weight_moist", title.c_str(), "γ_moist", weight, weigh(*largest));
  }

  json rows = json::array();

 private:
  ShownUnit stress_;
};

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
    const std::string model = get_word(soil, "model");
    Properties properties(units.stress);
    const auto density = find_si(soil, "grain_density"), porosity = find_si(soil, "porosity");
    properties.add("grain_density", "density of the grains", "ρs", {"kg/m³", 1}, density);
    properties.add("porosity", "porosity", "n", {"-", 1}, porosity);
    if (density && porosity)
      properties.add("unit_weight", "unit weight (dry)", "γ", {"kN/m³", 1000}, (1 - *porosity) * *density * gravity);
    const model::PoreWater pore_water = read_pore_water(soil);
    if (density && porosity && pore_water.is_wet())
      properties.add_wet_weights(summary, pore_water, *density, *porosity, gravity);
    properties.add("young_modulus", "Young's modulus", "E", {"MPa", 1e6}, find_si(soil, "young_modulus"));
    properties.add("poisson_ratio", "Poisson's ratio", "ν", {"-", 1}, find_si(soil, "poisson_ratio"));
    if (model == "mohr_coulomb") properties.add_strength(soil, stage_factor, factor_of_safety);
    json row{{"name", name},
             {"index", index++},
             {"model", model == "mohr_coulomb"     ? "Mohr–Coulomb"
                       : model == "linear_elastic" ? "linear elastic"
                                                   : model},
             {"regions", own_regions},
             {"properties", properties.rows}};
    if (json water = describe_soil_water(summary, soil); !water.is_null()) row["water"] = std::move(water);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace talus::report
