// SPDX-License-Identifier: MIT
#include "report/content/soil_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "input/case/soil_water_law.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Points of a curve: enough for a chart of some hundred pixels.
constexpr int curve_points = 81;
/// Suctions between which a soil is drawn [Pa], whatever its law.
constexpr double least_suction = 10, most_suction = 1e9;

std::string name_retention(const input::PoreWater& soil) {
  switch (soil.retention) {
    case input::RetentionCurve::van_genuchten:
      return "van Genuchten";
    case input::RetentionCurve::linear:
      return "linear in suction";
    case input::RetentionCurve::exponential:
      return "exponential, after Gardner";
    case input::RetentionCurve::table:
      return fmt::format("table of {} pairs, joined by monotone cubics", soil.retention_table.size());
    default:
      return "saturated at any suction";
  }
}

std::string name_conductivity(const input::PoreWater& soil) {
  const std::string of = soil.measure == input::SaturationShare::effective ? " of the effective saturation"
                                                                           : " of the degree of saturation";
  switch (soil.relative_conductivity) {
    case input::ConductivityCurve::mualem:
      return "Mualem," + of;
    case input::ConductivityCurve::hillel:
      return "power (Hillel)" + of;
    case input::ConductivityCurve::exponential:
      return "exponential in suction, after Gardner";
    case input::ConductivityCurve::table:
      return fmt::format("table of {} pairs", soil.conductivity_table.size());
    default:
      return "constant: that of the saturated soil at any suction";
  }
}

json list_parameters(const input::PoreWater& soil, const ShownUnits& units, double conductivity) {
  using R = input::RetentionCurve;
  using K = input::ConductivityCurve;
  const ShownUnit &stress = units.stress, share{"-", 1}, speed = units.speed();
  json rows = json::array();
  const auto add = [&](const char* key, const char* title, const char* symbol, const ShownUnit& unit, double value) {
    rows.push_back({{"key", key},
                    {"title", title},
                    {"symbol", symbol},
                    {"unit", unit.name},
                    {"value", round_to_digits(value / unit.si, 12)}});
  };
  const bool is_van_genuchten = soil.retention == R::van_genuchten;
  const bool falls = is_van_genuchten || soil.retention == R::linear || soil.retention == R::exponential;
  const K relative = soil.relative_conductivity;
  if (falls) add("minimum_saturation", "lowest degree of saturation", "S_min", share, soil.minimum_saturation);
  if (falls || soil.retention == R::saturated)
    add("maximum_saturation", "degree of saturation below the water table", "S_max", share, soil.maximum_saturation);
  if (is_van_genuchten) add("reference_pressure", "reference pressure", "p_ref", stress, soil.reference_pressure);
  if (is_van_genuchten || relative == K::mualem) add("lambda", "exponent (m of others)", "λ", share, soil.lambda);
  if (soil.retention == R::linear)
    add("dry_suction", "suction at the lowest saturation", "s_dry", stress, soil.dry_suction);
  if (soil.retention == R::exponential || relative == K::exponential)
    add("decay", "decay with suction", "α", {"1/" + stress.name, 1 / stress.si}, soil.decay);
  if (soil.permeability) add("permeability", "intrinsic permeability", "κ", {"m²", 1}, *soil.permeability);
  if (conductivity > 0) add("conductivity", "conductivity, saturated", "k_s", speed, conductivity);
  if (relative == K::hillel) add("exponent", "exponent of the conductivity", "r", share, soil.exponent);
  if (soil.air_entry.value_or(0) > 0)
    add("air_entry", "suction from which the conductivity falls", "s_a", stress, *soil.air_entry);
  if (soil.chi == input::BishopChi::khalili_khabbaz)
    add("chi_air_entry", "air entry of Bishop's χ", "s_e", stress, soil.chi_air_entry);
  return rows;
}

/// Suction at which the soil has lost this share of what it can lose [Pa]; `most` when it never has.
double find_suction(const input::PoreWater& soil, double lost, double most) {
  const auto curve = input::make_retention(soil);
  const auto at = [&](double s) { return material::find_water(curve, s); };
  const double full = at(0.0).saturation, rest = at(most_suction).saturation, wanted = full - lost * (full - rest);
  double low = std::log(least_suction), high = std::log(most_suction);
  if (!(full - rest > 1e-9) || at(most).saturation > wanted) return most;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (at(std::exp(middle)).saturation > wanted ? low : high) = middle;
  }
  return std::exp(high);
}

json sample_curves(const input::PoreWater& soil, double conductivity, std::optional<double> largest) {
  const auto retention = input::make_retention(soil);
  const auto relative = input::make_relative_conductivity(soil);
  // From where the soil begins to drain to where little is left, and to what the model has seen.
  const double drained = find_suction(soil, 0.8, 1e8);
  double low = find_suction(soil, 0.01, 1e3) / 3, high = drained < 1e8 ? 3 * drained : 3e5;
  if (largest) high = std::max(high, 2 * *largest);
  low = std::min(low, high / 100);
  json suctions = json::array(), saturations = json::array(), conductivities = json::array();
  for (int i = 0; i < curve_points; ++i) {
    const double s = low * std::pow(high / low, i / (curve_points - 1.0));
    const auto water = material::find_water(retention, s);
    suctions.push_back(s);
    saturations.push_back(water.saturation);
    if (conductivity > 0)
      conductivities.push_back(conductivity *
                               std::visit([&](const auto& law) { return law.evaluate(water).value; }, relative));
  }
  return {{"suction", suctions},
          {"saturation", saturations},
          {"conductivity", conductivities},
          {"largest_suction", largest ? json(*largest) : json()}};
}

}  // namespace

bool is_wet(const ResultFolder& folder) {
  const auto& materials = folder.data.materials;
  return folder.run.water || folder.run.seepage ||
         std::any_of(materials.begin(), materials.end(), [](const auto& named) { return named.second.water.is_wet(); });
}

std::optional<double> find_largest_suction(const results::RunResult& run) {
  const double largest =
      std::max(run.water ? run.water->largest_suction : 0, run.seepage ? run.seepage->largest_suction : 0);
  return largest > 0 ? std::optional(largest) : std::nullopt;
}

double find_saturation(const input::PoreWater& soil, double suction) {
  return material::saturation(input::make_retention(soil), suction);
}

json describe_soil_water(const ResultFolder& folder, const input::PoreWater& soil) {
  if (!soil.is_wet()) return {};
  const input::Water& water = folder.data.water;
  const double conductivity = input::find_saturated_conductivity(soil, water, water.drag_gravity);
  json block{{"retention", name_retention(soil)},
             {"conductivity", name_conductivity(soil)},
             {"chi", soil.chi == input::BishopChi::khalili_khabbaz
                         ? "χ after Khalili and Khabbaz: (s/s_e)^(−0.55) above the air entry, 1 below"
                         : "χ = S"},
             {"parameters", list_parameters(soil, read_units(folder.run), conductivity)}};
  block["curves"] = sample_curves(soil, conductivity, find_largest_suction(folder.run));
  return block;
}

}  // namespace talus::report
