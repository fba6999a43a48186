// SPDX-License-Identifier: MIT
#include "report/content/water.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/numbers.hpp"
#include "input/case/hydraulic.hpp"
#include "input/case/soil_water_law.hpp"
#include "report/content/model.hpp"
#include "report/folder/numbers.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::report {

using input::WaterCondition;
using nlohmann::json;

namespace {

/// The values of a hydraulic condition over time, in the unit of display.
struct Shown {
  const char* title;
  ShownUnit unit;
  std::vector<double> time, values;  ///< [s] and [unit]

  bool is_negative() const {
    return std::any_of(values.begin(), values.end(), [](double v) { return v < 0; });
  }
};

json to_json(const Shown& shown) {
  return {
      {"title", shown.title}, {"unit", report::to_json(shown.unit)}, {"time", shown.time}, {"values", shown.values}};
}

/// Returns nullopt for a condition without a value.
std::optional<Shown> read_series(const input::Hydraulic& h, const ShownUnits& units) {
  const ShownUnit rain = units.rain();
  const auto show = [&](const char* title, const ShownUnit& unit) -> std::optional<Shown> {
    const input::TimeTable series = h.values();
    if (series.time.empty()) return std::nullopt;
    Shown shown{title, unit, series.time, {}};
    for (const double v : series.value) shown.values.push_back(round_to_digits(v / unit.si, 12));
    return shown;
  };
  switch (h.condition) {
    case WaterCondition::total_head:
      return show("level", units.length);
    case WaterCondition::pressure:
      return show("pore pressure", units.stress);
    case WaterCondition::rain:
      return show("rain", rain);
    case WaterCondition::flux:
      return show("inflow", rain);
    default:
      return std::nullopt;
  }
}

/// Returns a value or a range: "10 m", "0 to 20 mm/h".
std::string show_range(const Shown& series) {
  const auto [low, high] = std::minmax_element(series.values.begin(), series.values.end());
  return *low == *high ? show_number(*low, 4) + " " + series.unit.name
                       : fmt::format("{} to {} {}, as the series says", show_number(*low, 4), show_number(*high, 4),
                                     series.unit.name);
}

std::string describe(const input::Hydraulic& h, const std::optional<Shown>& series, const ShownUnits& units) {
  const std::string value = series ? show_range(*series) : "";
  const bool is_negative = series && series->is_negative();
  switch (h.condition) {
    case WaterCondition::total_head:
      return "standing water up to y = " + value + "; above it, a seepage face";
    case WaterCondition::pressure:
      return "pore pressure " + value + " (suction is negative)";
    case WaterCondition::seepage_face:
      return "water may leave at zero pressure, none enters";
    case WaterCondition::flux:
      return value + " enters" + (is_negative ? " (what is negative is pumped out)" : "") + ", whatever the pressure";
    case WaterCondition::no_flow:
      return "no water passes";
    case WaterCondition::free_drainage:
      return "water drains downwards by its weight alone, under a gradient of 1";
    case WaterCondition::rain:
      break;
  }
  std::string text = value +
                     (h.rain == input::RainDirection::normal ? " on the inclined surface itself" : ", vertical") +
                     "; what does not enter runs off";
  if (is_negative) {
    text += "; negative rain evaporates";
    if (std::isfinite(h.suction_limit)) text += ", up to a suction of " + show(h.suction_limit, units.stress);
  }
  return text;
}

}  // namespace

std::string name_condition(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

json list_hydraulics(const ResultFolder& folder, const std::optional<mesh::Mesh<2>>& mesh) {
  json list = json::array();
  const ShownUnits units = read_units(folder.run);
  for (const input::Hydraulic& h : folder.data.hydraulics) {
    const std::string condition = input::get_word(h.condition);
    const std::optional<Shown> series = read_series(h, units);
    json lines = json::array();
    if (get_dimension(folder.run) == 2) lines = find_boundary_lines(h.on, folder.data.mesh, mesh);
    json entry{{"on", h.on},
               {"condition", condition},
               {"title", name_condition(condition)},
               {"text", describe(h, series, units)},
               {"lines", lines}};
    if (series) entry["series"] = to_json(*series);
    list.push_back(std::move(entry));
  }
  return list;
}

using nlohmann::json;

namespace {

/// Number of points of a curve, sufficient for a chart of some hundred pixels.
constexpr int curve_points = 81;
/// Limits of the suction in the curves of a soil [Pa].
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
  if (soil.conductivity_ratio != 1) {
    add("conductivity_ratio", "conductivity across bedding over that along it", "r_k", share, soil.conductivity_ratio);
    add("conductivity_inclination", "inclination of this bedding", "β", {"°", std::numbers::pi / 180},
        soil.conductivity_inclination);
  }
  if (relative == K::hillel) add("exponent", "exponent of the conductivity", "r", share, soil.exponent);
  if (soil.air_entry.value_or(0) > 0)
    add("air_entry", "suction from which the conductivity falls", "s_a", stress, *soil.air_entry);
  if (soil.chi == input::BishopChi::khalili_khabbaz)
    add("chi_air_entry", "air entry of Bishop's χ", "s_e", stress, soil.chi_air_entry);
  return rows;
}

/// Returns the suction at which the soil has lost the fraction `lost` of its drainable water [Pa]; `most` if it never
/// does.
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
  // The range of suction extends from the start of drainage to nearly residual saturation, and to the largest suction
  // of the model.
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

using nlohmann::json;

namespace {

/// Returns the state before the season.
std::string describe_first_state(const ResultFolder& folder) {
  if (folder.run.input.is_empty()) return "";
  const input::InitialWater& water = folder.data.initial.water;
  if (water.pressure == input::InitialPressure::seepage)
    return "steady seepage with the hydraulic conditions of the start";
  if (water.pressure == input::InitialPressure::zero) return "no pore pressure";
  if (water.pressure == input::InitialPressure::grid)
    return fmt::format("values at points, {}, from the table '{}'", get_word(water.table->quantity), water.table->file);
  std::string text = "hydrostatic under a water table, with suction above it";
  for (const input::PiezometricLine& line : water.lines)
    text += fmt::format("; in {} under a piezometric line of its own", fmt::join(line.materials, ", "));
  if (std::isfinite(water.largest_suction))
    text += " up to " + show(water.largest_suction, read_units(folder.run).stress);
  return text;
}

std::string describe_start(const ResultFolder& folder) {
  std::string text = describe_first_state(folder);
  if (folder.run.season && !text.empty())
    text += fmt::format(", and {:.4g} days of weather since then", folder.run.season->duration / 86400);
  return text;
}

/// Returns "Saturated and unsaturated soil" if a wet soil has a retention curve, otherwise "Saturated soil".
std::string describe_state(const ResultFolder& folder) {
  bool drains = false, dry = false;
  for (const auto& [name, soil] : folder.data.materials) {
    dry = dry || !soil.water.is_wet();
    drains = drains || (soil.water.is_wet() && soil.water.retention != input::RetentionCurve::saturated);
  }
  std::string text = drains ? "Saturated and unsaturated soil" : "Saturated soil";
  if (dry) text += " beside dry soil";
  const std::string start = describe_start(folder);
  return text + (start.empty() ? "" : "; at the start " + start);
}

json list_properties(const input::Water& water) {
  json rows = json::array();
  const auto add = [&](const char* key, const char* title, const char* symbol, const char* unit, double value) {
    if (!std::isfinite(value)) return;
    rows.push_back(
        {{"key", key}, {"title", title}, {"symbol", symbol}, {"unit", unit}, {"value", round_to_digits(value, 12)}});
  };
  add("density", "density of the water", "ρ_w", "kg/m³", water.density);
  add("bulk_modulus", "bulk modulus of the water", "K_w", "MPa", water.bulk_modulus / 1e6);
  add("viscosity", "dynamic viscosity", "μ_d", "Pa·s", water.viscosity);
  add("drag_gravity", "gravity at which conductivities hold", "g", "m/s²", water.drag_gravity);
  return rows;
}

}  // namespace

json make_water(const ResultFolder& folder) {
  if (!is_wet(folder)) return {};
  std::optional<mesh::Mesh<2>> mesh;
  if (get_dimension(folder.run) == 2 && std::filesystem::exists(folder.path / "mesh.h5"))
    mesh = run::get_mesh<2>(output::ArchiveReader(folder.path / "mesh.h5"));
  return {{"state", describe_state(folder)},
          {"initial", describe_start(folder)},
          {"properties", list_properties(folder.data.water)},
          {"conditions", list_hydraulics(folder, mesh)}};
}

}  // namespace talus::report
