#include "report/content/soil_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "input/case/declare_water.hpp"
#include "input/case/soil_water_law.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Points of a curve: enough for a chart of some hundred pixels.
constexpr int curve_points = 81;
/// Suctions between which a soil is drawn [Pa], whatever its law.
constexpr double least_suction = 10, most_suction = 1e9;

/// The value that a word of the echo stands for.
template <class Enum>
void read_choice(const json& table, const char* key, Enum& value) {
  const std::string word = get_word(table, key);
  for (const auto& choice : input::choices<Enum>)
    if (word == choice.word) value = choice.value;
}

void read_number(const json& table, const char* key, double& value) {
  value = find_si(table, key).value_or(value);
}

/// Pairs of a suction, in the unit of the key, and a share.
void read_pairs(const json& table, const char* key, std::vector<std::array<double, 2>>& pairs) {
  const std::string unit = get_text(table, {key, "unit"});
  const double si = unit.empty() ? 1 : units::get_si_factor(unit);
  for (const json& row : find_list(table, {key, "value"}))
    pairs.push_back({row.at(0).get<double>() * si, row.at(1).get<double>()});
}

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

class Parameters {
 public:
  Parameters(const json& echo, const ShownUnit& stress) : echo_(echo), stress_(stress) {}

  /// Only what the case gives for these laws is echoed.
  void add(const char* key, const char* title, const char* symbol, const ShownUnit& unit) {
    if (const auto value = find_si(echo_, key)) add(key, title, symbol, unit, *value);
  }
  void add_pressure(const char* key, const char* title, const char* symbol) { add(key, title, symbol, stress_); }
  void add(const char* key, const char* title, const char* symbol, const ShownUnit& unit, double value) {
    rows.push_back({{"key", key},
                    {"title", title},
                    {"symbol", symbol},
                    {"unit", unit.name},
                    {"value", std::stod(fmt::format("{:.12g}", value / unit.si))}});
  }

  json rows = json::array();

 private:
  const json& echo_;
  ShownUnit stress_;
};

json list_parameters(const json& echo, const ShownUnit& stress, double conductivity) {
  const ShownUnit share{"-", 1};
  Parameters p(echo, stress);
  p.add("minimum_saturation", "lowest degree of saturation", "S_min", share);
  p.add("maximum_saturation", "degree of saturation below the water table", "S_max", share);
  p.add_pressure("reference_pressure", "reference pressure", "p_ref");
  p.add("lambda", "exponent (m of others)", "λ", share);
  p.add_pressure("dry_suction", "suction at the lowest saturation", "s_dry");
  p.add("decay", "decay with suction", "α", {"1/" + stress.name, 1 / stress.si});
  p.add("permeability", "intrinsic permeability", "κ", {"m²", 1});
  if (conductivity > 0) p.add("conductivity", "conductivity, saturated", "k_s", {"m/s", 1}, conductivity);
  p.add("exponent", "exponent of the conductivity", "r", share);
  p.add_pressure("air_entry", "suction from which the conductivity falls", "s_a");
  p.add_pressure("chi_air_entry", "air entry of Bishop's χ", "s_e");
  return p.rows;
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

input::PoreWater read_pore_water(const json& material) {
  input::PoreWater soil;
  const json* echo = find(material, {"water"});
  if (echo == nullptr) return soil;
  read_choice(*echo, "retention", soil.retention);
  read_choice(*echo, "relative_conductivity", soil.relative_conductivity);
  read_choice(*echo, "measure", soil.measure);
  read_choice(*echo, "chi", soil.chi);
  read_number(*echo, "minimum_saturation", soil.minimum_saturation);
  read_number(*echo, "maximum_saturation", soil.maximum_saturation);
  read_number(*echo, "reference_pressure", soil.reference_pressure);
  read_number(*echo, "lambda", soil.lambda);
  read_number(*echo, "dry_suction", soil.dry_suction);
  read_number(*echo, "decay", soil.decay);
  read_number(*echo, "exponent", soil.exponent);
  read_number(*echo, "chi_air_entry", soil.chi_air_entry);
  soil.conductivity = find_si(*echo, "conductivity");
  soil.permeability = find_si(*echo, "permeability");
  soil.air_entry = find_si(*echo, "air_entry");
  read_pairs(*echo, "retention_table", soil.retention_table);
  read_pairs(*echo, "conductivity_table", soil.conductivity_table);
  return soil;
}

input::Water read_water(const json& summary) {
  input::Water water;
  const json* echo = find(summary, {"input", "water"});
  if (echo == nullptr) return water;
  read_number(*echo, "density", water.density);
  // JSON has no infinity: a modulus without limit is null.
  if (echo->contains("bulk_modulus"))
    water.bulk_modulus = find_si(*echo, "bulk_modulus").value_or(std::numeric_limits<double>::infinity());
  read_number(*echo, "viscosity", water.viscosity);
  read_number(*echo, "drag_gravity", water.drag_gravity);
  return water;
}

bool is_wet(const json& summary) {
  if (find(summary, {"water"}) != nullptr || find(summary, {"seepage"}) != nullptr) return true;
  const json* materials = find(summary, {"input", "materials"});
  return materials != nullptr && materials->is_object() &&
         std::any_of(materials->begin(), materials->end(),
                     [](const json& material) { return read_pore_water(material).is_wet(); });
}

std::optional<double> find_largest_suction(const json& summary) {
  const double largest =
      std::max(get_number(summary, {"water", "largest_suction"}), get_number(summary, {"seepage", "largest_suction"}));
  return largest > 0 ? std::optional(largest) : std::nullopt;
}

double find_saturation(const input::PoreWater& soil, double suction) {
  return material::saturation(input::make_retention(soil), suction);
}

json describe_soil_water(const json& summary, const json& material) {
  const input::PoreWater soil = read_pore_water(material);
  if (!soil.is_wet()) return {};
  const input::Water water = read_water(summary);
  const double conductivity = input::find_saturated_conductivity(soil, water, water.drag_gravity);
  json block{{"retention", name_retention(soil)},
             {"conductivity", name_conductivity(soil)},
             {"chi", soil.chi == input::BishopChi::khalili_khabbaz
                         ? "χ after Khalili and Khabbaz: (s/s_e)^(−0.55) above the air entry, 1 below"
                         : "χ = S"},
             {"parameters", list_parameters(material.at("water"), read_units(summary).stress, conductivity)}};
  block["curves"] = sample_curves(soil, conductivity, find_largest_suction(summary));
  return block;
}

}  // namespace talus::report
