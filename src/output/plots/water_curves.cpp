// SPDX-License-Identifier: MIT
#include "output/plots/water_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/case/soil_water_law.hpp"
#include "output/files/history.hpp"

namespace talus::output {
namespace {

constexpr int steps_per_decade = 60;

/// A soil's laws, made once.
struct Laws {
  material::Retention retention;
  material::Conductivity relative;

  material::SoilWater<double> at(double suction) const { return material::find_water(retention, suction); }
  double relative_at(double suction) const { return material::find_relative_conductivity(relative, at(suction)).value; }
};

std::string in_kpa(double pressure) {
  return fmt::format("{:.4g} kPa", pressure / 1e3);
}

std::string describe_limits(const input::PoreWater& soil) {
  return fmt::format("S from {:.4g} to {:.4g}", soil.maximum_saturation, soil.minimum_saturation);
}

std::string describe_retention(const input::PoreWater& soil) {
  using enum input::RetentionCurve;
  switch (soil.retention) {
    case van_genuchten:
      return fmt::format("van Genuchten, p_ref = {}, λ = {:.4g}, {}", in_kpa(soil.reference_pressure), soil.lambda,
                         describe_limits(soil));
    case linear:
      return fmt::format("linear, {} at {}", describe_limits(soil), in_kpa(soil.dry_suction));
    case exponential:
      return fmt::format("exponential, α = {:.4g} 1/kPa, {}", soil.decay * 1e3, describe_limits(soil));
    case table:
      return fmt::format("table of {} pairs", soil.retention_table.size());
    case dry:
    case saturated:
      break;
  }
  return fmt::format("saturated at any suction, S = {:.4g}", soil.maximum_saturation);
}

std::string describe_relative(const input::PoreWater& soil) {
  using enum input::ConductivityCurve;
  const std::string measure = soil.measure == input::SaturationShare::total ? "S" : "S_e";
  switch (soil.relative_conductivity) {
    case mualem:
      return fmt::format("Mualem in {}, λ = {:.4g}{}", measure, soil.lambda,
                         soil.air_entry.value_or(0) > 0 ? ", air entry " + in_kpa(*soil.air_entry) : "");
    case hillel:
      return fmt::format("Hillel in {}, r = {:.4g}", measure, soil.exponent);
    case exponential:
      return fmt::format("exponential, α = {:.4g} 1/kPa", soil.decay * 1e3);
    case table:
      return fmt::format("table of {} pairs", soil.conductivity_table.size());
    case constant:
      break;
  }
  return "constant";
}

/// 1e-9 rather than 1e-09.
std::string shorten(double value) {
  std::string text = fmt::format("{:.3g}", value);
  const std::size_t at = text.find("e-0");
  return at == std::string::npos ? text : text.erase(at + 2, 1);
}

std::string describe_conductivity(const input::PoreWater& soil, double saturated) {
  const std::string source =
      soil.conductivity ? "" : fmt::format(" (κ = {} m²)", shorten(soil.permeability.value_or(0)));
  return fmt::format("{}, k = {} m/s when saturated{}", describe_relative(soil), shorten(saturated), source);
}

/// χ of Khalili and Khabbaz (1998).
double find_chi(double suction, double air_entry) {
  return suction > air_entry ? std::pow(suction / air_entry, -0.55) : 1;
}

/// True when a curve of the soil changes visibly between two suctions [Pa].
bool changes(const Laws& laws, double from, double to) {
  return std::abs(laws.at(from).saturation - laws.at(to).saturation) > 5e-3 ||
         std::abs(std::log10(std::max(laws.relative_at(from), 1e-12) / std::max(laws.relative_at(to), 1e-12))) > 0.02;
}

/// First and last power of ten [Pa] of the suction axis.
std::pair<int, int> find_decades(const std::vector<std::pair<const input::Material*, Laws>>& soils) {
  int low = 1, high = 7;
  std::vector<double> pairs;
  for (const auto& [material, laws] : soils) {
    for (const auto& pair : material->water.retention_table) pairs.push_back(pair[0]);
    for (const auto& pair : material->water.conductivity_table) pairs.push_back(pair[0]);
  }
  std::erase_if(pairs, [](double s) { return !(s > 0); });
  double first = 1e300, last = 0;
  for (const double s : pairs) first = std::min(first, s), last = std::max(last, s);
  if (last > 0) low = std::min(low, static_cast<int>(std::floor(std::log10(first))));
  if (last > 0) high = std::max(high, static_cast<int>(std::ceil(std::log10(last))));
  const auto quiet = [&](int decade) {
    const double from = std::pow(10, decade), to = 10 * from;
    return std::ranges::none_of(soils, [&](const auto& soil) { return changes(soil.second, from, to); }) &&
           std::ranges::none_of(pairs, [&](double s) { return s >= from && s <= to; });
  };
  if (std::ranges::all_of(soils, [](const auto& soil) { return !changes(soil.second, 10, 1e7); })) return {low, high};
  while (high - low > 2 && quiet(low)) ++low;
  while (high - low > 2 && quiet(high - 1)) --high;
  return {low, high};
}

WaterCurves sample(const std::string& name, const input::PoreWater& soil, const Laws& laws, double saturated,
                   std::pair<int, int> decades) {
  WaterCurves curves;
  curves.material = name;
  curves.retention = describe_retention(soil);
  curves.conductivity = describe_conductivity(soil, saturated);
  curves.saturated_conductivity = saturated;
  const bool has_chi = soil.chi == input::BishopChi::khalili_khabbaz;
  const int steps = (decades.second - decades.first) * steps_per_decade;
  for (int i = 0; i <= steps; ++i) {
    const double s = std::pow(10, decades.first + static_cast<double>(i) / steps_per_decade);
    const material::SoilWater<double> water = laws.at(s);
    curves.suction.push_back(s);
    curves.saturation.push_back(water.saturation);
    curves.slope.push_back(water.slope);
    curves.relative.push_back(laws.relative_at(s));
    if (has_chi) curves.chi.push_back(find_chi(s, soil.chi_air_entry));
  }
  if (soil.retention == input::RetentionCurve::table) curves.saturation_pairs = soil.retention_table;
  if (soil.relative_conductivity == input::ConductivityCurve::table) curves.relative_pairs = soil.conductivity_table;
  if (soil.relative_conductivity == input::ConductivityCurve::mualem && soil.air_entry.value_or(0) > 0)
    curves.air_entry = soil.air_entry;
  return curves;
}

}  // namespace

std::vector<WaterCurves> sample_water_curves(const input::Case& data) {
  std::vector<std::pair<const input::Material*, Laws>> soils;
  std::vector<std::string> names;
  for (const auto& [name, material] : data.materials) {
    if (!material.water.is_wet()) continue;
    names.push_back(name);
    soils.push_back(
        {&material, {input::make_retention(material.water), input::make_relative_conductivity(material.water)}});
  }
  std::vector<WaterCurves> curves;
  if (soils.empty()) return curves;
  const std::pair<int, int> decades = find_decades(soils);
  for (std::size_t i = 0; i < soils.size(); ++i) {
    const input::PoreWater& soil = soils[i].first->water;
    // The value as it was measured, at the gravity of the laboratory.
    const double saturated = input::find_saturated_conductivity(soil, data.water, data.water.drag_gravity);
    curves.push_back(sample(names[i], soil, soils[i].second, saturated, decades));
  }
  return curves;
}

std::string make_water_table(const std::vector<WaterCurves>& soils) {
  std::string text =
      "material,suction [kPa],saturation [-],saturation_slope [1/kPa],bishop_chi [-],relative_conductivity [-],"
      "conductivity [m/s]\n";
  for (const WaterCurves& soil : soils)
    for (std::size_t i = 0; i < soil.suction.size(); ++i)
      text += fmt::format("{},{},{},{},{},{},{}\n", quote_field(soil.material), to_shortest(soil.suction[i] / 1e3),
                          to_shortest(soil.saturation[i]), to_shortest(soil.slope[i] * 1e3),
                          to_shortest(soil.chi.empty() ? soil.saturation[i] : soil.chi[i]),
                          to_shortest(soil.relative[i]), to_shortest(soil.relative[i] * soil.saturated_conductivity));
  return text;
}

}  // namespace talus::output
