// SPDX-License-Identifier: MIT
#pragma once
// [materials.NAME]: the soils. Strength parameters have no defaults, so that an omission is reported.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/strength_law.hpp"
#include "input/case/water.hpp"
#include "input/language/spec.hpp"
#include "material/law.hpp"

namespace talus::input {

// [materials.NAME]: parameters for LEM and FEM other than strength.

/// Contribution of suction to the strength on a slip surface.
enum class SuctionStrength { from_water, none, saturation, phi_b };

/// The R envelope of isotropically consolidated undrained (CIU) tests, in total stresses.
struct UndrainedEnvelope {
  double cohesion = 0;        ///< c_R [Pa]
  double friction_angle = 0;  ///< φ_R [rad]
};

/// Parameters for LEM (and, where applicable, FEM) other than strength.
struct SliceSoil {
  std::optional<double> unit_weight;  ///< γ above the water table; replaces grain density and porosity [N/m³]
  std::optional<double> saturated_unit_weight;  ///< γ_sat, below the water table [N/m³]
  double pore_pressure_ratio = 0;               ///< r_u [-]
  SuctionStrength suction_strength =
      SuctionStrength::from_water;  ///< from_water: χ = S_w for soil with a retention curve, else none
  double phi_b = 0;                 ///< [rad]
  std::optional<double> b_bar;      ///< B̄ in drawdown [-]; not given: drained
  std::optional<UndrainedEnvelope> undrained_envelope;  ///< for drawdown; not given: drained
};

template <>
inline constexpr auto choices<SuctionStrength> = std::array{
    Choice{SuctionStrength::from_water, "from_water",
           "as \"saturation\" where [materials.NAME.water] has a retention curve, else \"none\""},
    Choice{SuctionStrength::none, "none", "nothing: no pore pressure above the water table"},
    Choice{SuctionStrength::saturation, "saturation", "χ s tan φ with χ = S, Bishop's effective stress"},
    Choice{SuctionStrength::phi_b, "phi_b", "s tan φᵇ, after Fredlund"},
};

/// Units in which unit weights are often given, in kN/m³.
inline std::vector<Slip> weight_slips() {
  return {{"kg/m3", 9.80665e-3}, {"t/m3", 9.80665}, {"N/m3", 1e-3}, {"pcf", 0.1570875}};
}

void describe(auto& v, UndrainedEnvelope& e) {
  v.key("cohesion", e.cohesion, quantity("kPa").at_least(0).required().example("57"), "c_R.");
  v.key("friction_angle", e.friction_angle, quantity("deg").at_least(0).below(90).required().example("16"), "φ_R.");
}

/// Declares the parameters for LEM and FEM other than strength; `unit_weight` is declared earlier.
void describe_slice_soil(auto& v, SliceSoil& s) {
  v.key("saturated_unit_weight", s.saturated_unit_weight,
        quantity("kN/m3").above(0).usual(10, 28, weight_slips()).example("20"),
        "Weight of the soil with its water below the water table, for LEM and FEM; if not given, that "
        "of grains and water where `grain_density` is given, else `unit_weight`.");
  v.key("pore_pressure_ratio", s.pore_pressure_ratio, plain().at_least(0).below(1),
        "r_u, pore pressure over the weight of the soil above, instead of a water table. MPM keeps it, at frozen "
        "geometry.");
  v.key("suction_strength", s.suction_strength, plain(),
        "Strength due to suction s above the water table, for LEM, FEM and limit analysis. MPM uses "
        "[materials.NAME.water].");
  v.key("phi_b", s.phi_b,
        quantity("deg")
            .at_least(0)
            .below(90)
            .needed_with("suction_strength", s.suction_strength, SuctionStrength::phi_b)
            .example("15"),
        "φᵇ of that.");
  v.key("b_bar", s.b_bar, plain().at_least(0).at_most(1).example("1"),
        "B̄, the change of the pore pressure over that of the vertical stress, where [lem.drawdown] has method = "
        "\"b_bar\". Soil without it drains.");
}

/// Declares the blocks of SliceSoil, which follow all keys.
void describe_slice_blocks(auto& v, SliceSoil& s) {
  v.optional_table("undrained_envelope", s.undrained_envelope,
                   "The R envelope c_R + σ' tan φ_R of isotropically consolidated undrained tests, in total stresses, "
                   "for [lem.drawdown]. Soil without it drains.");
}

using MaterialModel = material::Model;

/// The words of the constitutive laws, in their order.
template <>
inline constexpr auto choices<MaterialModel> = [] {
  std::array<Choice<MaterialModel>, material::Laws::traits.size()> list{};
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i] = {MaterialModel(i), material::Laws::traits[i].word, material::Laws::traits[i].meaning};
  return list;
}();

/// Parameters of all soils, and those of all laws, of which a case gives those of its model.
struct Material : material::SoilNumbers {
  MaterialModel model = material::model_of<material::LinearElastic>;
  bool reduced = true;                     ///< false: no factor of safety divides the strength
  double grain_density = 0;                ///< ρ_s [kg/m³]
  double porosity = 0;                     ///< n [-]
  std::optional<double> given_void_ratio;  ///< e_0 if given; the porosity follows from it [-]
  PoreWater water;                         ///< default: no pore water
  SliceSoil slices;
  std::shared_ptr<const StrengthLaw> known_strength{};  ///< total stress, for LEM and limit analysis in the place of
                                                        ///< that of the law; from a calculation, not a key

  const material::Traits& traits() const { return material::get_traits(model); }
  /// Returns e_0 = n/(1-n) [-].
  double void_ratio() const { return porosity / (1 - porosity); }
  /// Returns the dry bulk density (1-n)ρ_s [kg/m³].
  double density() const { return (1 - porosity) * grain_density; }
};

/// Returns the law of a material with another cohesion [Pa], reduced by `factor` if the material is to be reduced.
/// Throws as material::make_law().
inline material::Law make_law(const Material& m, std::optional<double> cohesion = {}, double factor = 1) {
  return material::make_law(m.model, m, {m.reduced ? factor : 1, cohesion});
}

/// Returns the soil of limit states: without softening, with the strength that the case names for them.
inline Material find_limit_soil(Material m) {
  material::stop_softening(m.model, m);
  return m;
}

void describe(auto& v, Material& m) {
  v.key("model", m.model, plain().required().by_methods({"lem", "fem", "bounds", "mpm"}).example(R"("mohr_coulomb")"),
        "How stress follows strain.");
  v.key("reduced", m.reduced, plain(),
        "false: the factor of safety does not divide the strength of this soil, as of a wall or of rock, in LEM, FEM, "
        "limit analysis and MPM. Partial factors divide it all the same.");
  v.key("unit_weight", m.slices.unit_weight, quantity("kN/m3").above(0).usual(10, 28, weight_slips()).example("18"),
        "γ, weight of the soil above the water table, instead of `grain_density` and porosity. Soil whose pore water "
        "moves ([materials.NAME.water]) needs its porosity all the same, and with MPM both.");
  const bool is_weighed = m.slices.unit_weight.has_value();
  v.key("grain_density", m.grain_density,
        quantity("kg/m3")
            .above(0)
            .usual(2000, 3500, {{"g/cm3", 1e3}, {"kN/m3", 101.972}})
            .required()
            .by_methods({"lem", "fem", "bounds", "mpm"})
            .unless_given("unit_weight", is_weighed)
            .example("2500"),
        "Density of the solid grains; the bulk density of the dry soil is (1 - porosity) times it.");
  v.key("void_ratio", m.given_void_ratio, plain().at_least(0).example("0.6"),
        "Volume of the pores over that of the grains at the start, e₀, instead of the porosity.");
  v.key("porosity", m.porosity,
        plain()
            .at_least(0)
            .below(1)
            .usual_or_zero(0.1, 0.9)
            .needed_without("void_ratio", m.given_void_ratio.has_value())
            .unless_given("unit_weight", is_weighed)
            .example("0.2"),
        "Share of the pores in the volume, e₀/(1+e₀).");
  m.for_each_block([&]<class Block>(Block& block) { describe(v, block, material::Laws::list_users<Block>(m.model)); });
  describe_slice_soil(v, m.slices);
  describe_slice_blocks(v, m.slices);
  v.table("water", m.water, "The pore water of this soil. Without this block the soil is dry.");
}

}  // namespace talus::input
