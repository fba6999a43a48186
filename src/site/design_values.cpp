// SPDX-License-Identifier: MIT
// Application of partial factors to soils, loads and weights, and the statement of the over-design factor.
#include "site/design_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "input/case/partial_factors.hpp"
#include "input/case/support.hpp"
#include "results/bounds.hpp"

namespace talus::site {
namespace {

constexpr double kilo = 1e3, degree = std::numbers::pi / 180;

std::vector<results::PartialFactor> list_values(const input::PartialFactorValues& v) {
  return {{"cohesion", "effective cohesion", "γ_c'", v.cohesion},
          {"friction", "tangent of the friction angle", "γ_φ'", v.friction},
          {"undrained", "undrained shear strength", "γ_cu", v.undrained},
          {"weight", "unit weight", "γ_γ", v.weight},
          {"permanent_load", "permanent actions", "γ_G", v.permanent_load},
          {"variable_load", "variable actions", "γ_Q", v.variable_load},
          {"resistance", "resistance", "γ_R;e", v.resistance}};
}

/// Divides the strength parameters of one soil or support by the partial factors and records each change.
class SoilFactors : public material::PartialDivision {
 public:
  SoilFactors(const std::string& name, const input::PartialFactorValues& v, std::vector<results::DesignValue>& out)
      : name_(name), results_(out) {
    cohesion = v.cohesion;
    friction = v.friction;
    undrained = v.undrained;
  }

  void divide(double& value, double factor, const char* quantity, const char* symbol, const char* unit,
              double unit_si) override {
    if (value == 0 || factor == 1 || std::isinf(value)) return;
    tell(quantity, symbol, unit, value / unit_si, value / factor / unit_si);
    value /= factor;
  }
  void divide(std::optional<double>& value, double factor, const char* quantity, const char* symbol, const char* unit,
              double unit_si) {
    if (value) divide(*value, factor, quantity, symbol, unit, unit_si);
  }
  void divide_angle(double& angle, double factor, const char* quantity, const char* symbol) override {
    if (angle == 0 || factor == 1) return;
    const double design = std::atan(std::tan(angle) / factor);
    tell(quantity, symbol, "deg", angle / degree, design / degree);
    angle = design;
  }

 private:
  void tell(const char* quantity, const char* symbol, const char* unit, double before, double after) {
    results_.push_back({name_, quantity, symbol, unit, round_to_digits(before, 12), round_to_digits(after, 12)});
  }
  const std::string& name_;
  std::vector<results::DesignValue>& results_;
};

void factor_soil(const std::string& name, input::Material& m, const input::PartialFactorValues& v,
                 std::vector<results::DesignValue>& out) {
  if (!m.traits().serves_slices ||
      (m.traits().strength == material::Strength::known && !material::is_divisible(m.model)))
    throw Error(ExitCode::wrong_input,
                fmt::format("material '{}' has no cohesion and friction angle that partial factors could divide; take "
                            "[partial_factors] out, or give the soil the model {}",
                            name, material::list_sliceable()));
  SoilFactors soil(name, v, out);
  material::divide_strength(m.model, m, soil);
  soil.divide_angle(m.slices.phi_b, v.friction, "friction angle of suction", "φ_b");
  soil.divide(m.slices.unit_weight, v.weight, "unit weight", "γ", "kN/m3", kilo);
  soil.divide(m.slices.saturated_unit_weight, v.weight, "unit weight below the water table", "γ_sat", "kN/m3", kilo);
  soil.divide(m.grain_density, v.weight, "density of the grains", "ρ_s", "kg/m3", 1);
}

/// Divides the resistances of a support. Where γ_G, which multiplies the weight, divides what is not weight instead, it
/// divides a prestress too, a favourable action without a factor; but not the friction of the bond, which follows the
/// weight.
void factor_support(const std::string& name, input::Support& s, const input::PartialFactorValues& v,
                    double permanent_load, std::vector<results::DesignValue>& out) {
  const std::string title = "support " + name;
  SoilFactors values(title, v, out);
  constexpr double kN = 1e3;
  values.divide(s.tensile_strength, v.tensile, "tensile strength", "T", "kN", kN);
  values.divide(s.plate, v.tensile, "resistance of plate and head", "R", "kN", kN);
  values.divide(s.strength, v.tensile, "tensile strength", "T", "kN/m", kN);
  values.divide(s.connection, v.tensile, "connection", "R", "kN/m", kN);
  values.divide(s.bond, v.bond, "bond", "q", "kN/m", kN);
  values.divide(s.bond_adhesion, v.bond, "adhesion of the bond", "a", "kPa", kN);
  if (s.bond_friction)
    values.divide(s.bond_scale, v.bond / permanent_load, "factor on the friction of the bond", "α", "", 1);
  values.divide(s.lateral_resistance, v.lateral, "lateral resistance", "R", "kN", kN);
  values.divide(s.shear_strength, v.lateral, "shear strength", "V", "kN", kN);
  values.divide(s.plastic_moment, v.lateral, "plastic moment", "M_p", "kN.m", kN);
  values.divide(s.plastic_force, v.lateral, "axial strength", "N_p", "kN", kN);
  values.divide(s.strut_strength, v.lateral, "strength of a strut", "S", "kN", kN);
  values.divide(s.prestress, permanent_load, "prestress", "P", "kN", kN);
  values.divide(s.strut_prestress, permanent_load, "prestress of a strut", "P", "kN", kN);
}

/// Returns the design values of the supports as one sentence; empty without any.
std::string describe_supports(const std::vector<results::DesignValue>& values) {
  std::string text;
  for (const results::DesignValue& v : values)
    text += fmt::format("{}{}, {} {:.4g} → {:.4g}{}{}", text.empty() ? "" : "; ", v.material, v.quantity,
                        v.characteristic, v.design, v.unit.empty() ? "" : " ", v.unit);
  return text.empty() ? "" : "Design values of supports: " + text + ".";
}

std::string list_words(const std::vector<results::PartialFactor>& values) {
  std::string text;
  for (const results::PartialFactor& v : values)
    if (v.value != 1.0) text += fmt::format("{}{} = {:g}", text.empty() ? "" : ", ", v.symbol, v.value);
  return text.empty() ? "all factors are 1" : text;
}

}  // namespace

DesignValues apply_partial_factors(const input::Case& data) {
  DesignValues result{data, 1, std::nullopt};
  const input::PartialFactorValues given = input::find_partial_factors(data.partial_factors);
  if (!given.is_active()) return result;
  result.resistance = given.resistance;
  // F/γ_R;e below the target is failure.
  if (result.data.timeline) result.data.timeline->target *= given.resistance;
  const input::PartialFactorValues v = input::divide_by_permanent(given);
  results::DesignStatement& out = result.statement.emplace();
  for (auto& [name, m] : result.data.materials) factor_soil(name, m, v, out.materials);
  for (input::Roots& roots : result.data.roots) {
    if (roots.cohesion) *roots.cohesion /= v.cohesion;
    if (roots.bundle)  // the cohesion of a bundle is proportional to the tensile strength of the roots
      for (double& strength : roots.bundle->strengths) strength /= v.cohesion;
  }
  std::vector<results::DesignValue> of_supports;
  for (auto& [name, support] : result.data.supports) {
    factor_support(name, support, v, given.permanent_load, of_supports);
    if (support.lateral_law == input::LateralLaw::ito_matsui && given.lateral != 1)
      out.notes.push_back(
          fmt::format("The lateral force of support '{}' by Ito and Matsui follows from the design strengths of the "
                      "soil; γ_lateral divides the strengths of its piles only.",
                      name));
  }
  for (input::Stage& stage : result.data.stages)
    if (stage.cohesion) *stage.cohesion /= v.cohesion;
  for (input::Surcharge& s : result.data.surcharges) {
    const double factor = s.variable ? v.variable_load : 1;
    for (double& q : s.load) q *= factor;
    out.surcharges.push_back({s.name, s.variable, factor});
  }
  if (given.permanent_load != 1)
    out.notes.push_back(
        fmt::format("γ_G = {:g} multiplies the weight of soil and water and the permanent loads alike (single source). "
                    "The calculation divides strengths in {} by γ_G and multiplies variable loads by γ_Q/γ_G = {:g}, "
                    "which gives the same factor of safety.",
                    given.permanent_load, data.units().stress.name, v.variable_load));
  if (std::string supports = describe_supports(of_supports); !supports.empty())
    out.notes.push_back(std::move(supports));
  out.materials.insert(out.materials.end(), of_supports.begin(), of_supports.end());
  if (data.timeline && given.resistance != 1)
    out.notes.push_back(
        fmt::format("The slope fails in time where its factor falls below the target {:g} times the resistance factor "
                    "γ_R;e = {:g}.",
                    data.timeline->target, given.resistance));
  if (!data.surcharges.empty())
    out.notes.push_back(
        "All surcharges are taken as unfavourable. Remove variable surcharges that stabilise the slope from the case.");
  out.set = given.set;
  out.values = list_values(given);
  if (!data.supports.empty())
    out.values.insert(out.values.end(), {{"bond", "pull-out resistance of supports", "γ_bond", given.bond},
                                         {"tensile", "tensile strength of supports", "γ_tensile", given.tensile},
                                         {"lateral", "lateral resistance of supports", "γ_lateral", given.lateral}});
  out.text = fmt::format("Partial factors {}: {}.", given.set, list_words(out.values));
  return result;
}

std::string describe_factored_quake(const input::Case& data) {
  const input::PartialFactorValues v = input::find_partial_factors(data.partial_factors);
  const bool shakes = data.earthquake.horizontal != 0 || data.earthquake.vertical != 0;
  const bool has_variable =
      std::any_of(data.surcharges.begin(), data.surcharges.end(), [](const input::Surcharge& s) { return s.variable; });
  const bool is_factored = v.permanent_load != 1 || (v.variable_load != 1 && has_variable);
  if (!shakes || !v.is_active() || !is_factored) return "";
  return fmt::format(
      "The case has an earthquake and the set {} with factors on actions (γ_G = {:g}, γ_Q = {:g}). In seismic design "
      "situations actions have none (EN 1990, 6.4.3.4), and EN 1998-5, 3.1(3) factors the strengths: set = "
      "\"EN1998-5\" does that.",
      v.set, v.permanent_load, v.variable_load);
}

void state_over_design(results::DesignStatement& statement, double resistance, double factor) {
  constexpr double rounding = 1e-9;  // tolerance of the quotient
  const double over_design = factor / resistance;
  statement.over_design = over_design;
  statement.text = fmt::format(
      "Partial factors {}: {}. The factor of safety with design values is {:.3f}{}: the over-design factor is "
      "{:.3f}, {}.",
      statement.set, list_words(statement.values), factor,
      resistance == 1 ? "" : fmt::format(", the resistance factor {:g}", resistance),
      results::show_lower(over_design + rounding),
      over_design >= 1 ? "which is at least 1 as required" : "below the 1 that is required");
}

}  // namespace talus::site
