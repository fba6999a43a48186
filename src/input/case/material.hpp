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
#include "material/soil.hpp"

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
      SuctionStrength::from_water;  ///< from_water: χ = S_w for soil with pore water of its own, else none
  double phi_b = 0;                 ///< [rad]
  std::optional<double> b_bar;      ///< B̄ in drawdown [-]; not given: drained
  std::optional<UndrainedEnvelope> undrained_envelope;  ///< for drawdown; not given: drained
};

template <>
inline constexpr auto choices<SuctionStrength> = std::array{
    Choice{SuctionStrength::from_water, "from_water",
           "χ s tan φ with χ = S, also where it stays 1, in soil with [materials.NAME.water], else \"none\""},
    Choice{SuctionStrength::none, "none", "nothing: no pore pressure above the water table"},
    Choice{SuctionStrength::saturation, "saturation", "χ s tan φ with χ = S, Bishop's effective stress"},
    Choice{SuctionStrength::phi_b, "phi_b", "s tan φᵇ, after Fredlund"},
};

/// Units in which unit weights are often given, in kN/m³.
inline std::vector<Slip> weight_slips() {
  return {{"kg/m3", 9.80665e-3}, {"t/m3", 9.80665}, {"N/m3", 1e-3}, {"pcf", 0.1570875}};
}

void describe(Visitor& v, UndrainedEnvelope& e);

using MaterialModel = material::Model;

/// The words of the constitutive laws, in their order.
struct ModelChoices {
  const Choice<MaterialModel>* begin() const;
  const Choice<MaterialModel>* end() const { return begin() + size(); }
  static constexpr std::size_t size() { return material::model_count; }
  const Choice<MaterialModel>& operator[](std::size_t i) const { return begin()[i]; }
};
template <>
inline constexpr ModelChoices choices<MaterialModel>{};

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
material::Law make_law(const Material& m, std::optional<double> cohesion = {}, double factor = 1);

/// Returns the soil of limit states: without softening, with the strength that the case names for them.
inline Material find_limit_soil(Material m) {
  material::stop_softening(m.model, m);
  return m;
}

void describe(Visitor& v, Material& m);

}  // namespace talus::input
