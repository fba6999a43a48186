// SPDX-License-Identifier: MIT
#pragma once
// State of pore water: pressure from the water content, effective-stress term χp, and relative conductivity.

#include "mpm/state/water.hpp"

namespace talus::mpm {

/// Smallest relative conductivity; zero would be an infinite drag.
inline constexpr double lowest_relative_conductivity = 1e-12;

template <class T>
struct PoreState {
  T pressure;    ///< p, tension positive [Pa]
  T saturation;  ///< S [-]
  T bishop;      ///< χ p, the pore-pressure term of the total stress [Pa]
  T relative;    ///< k_r, at least lowest_relative_conductivity [-]
  T capacity;    ///< d content/dp, negative [1/Pa]
};

using talus::select;
template <class T>
TALUS_KERNEL PoreState<T> select(MaskOf<T> c, const PoreState<T>& a, const PoreState<T>& b) {
  return {select(c, a.pressure, b.pressure), select(c, a.saturation, b.saturation), select(c, a.bishop, b.bishop),
          select(c, a.relative, b.relative), select(c, a.capacity, b.capacity)};
}

/// Pressure at which pores hold `content` = m_w/(ρ_w V_pores) [-]: S(p) e^(-p/K_w) = content (T14.7), from `guess`
/// [Pa]. A guess extrapolated from the last state by its capacity is accurate to second order; one evaluation of the
/// retention curve then suffices. The result of inactive lanes is undefined.
template <class T>
PoreState<T> find_pore_state(const WaterLaw& law, T content, T guess, MaskOf<T> active);

/// The state at a known pressure.
template <class T>
TALUS_PORTABLE PoreState<T> find_state_at_pressure(const WaterLaw& law, T pressure);

/// ρ_w g/k of the saturated soil: drag force per volume and Darcy flux [N s/m⁴].
TALUS_PORTABLE inline double find_saturated_resistance(const WaterLaw& law, double conductivity_factor) {
  return law.density * law.drag_gravity / (law.conductivity * conductivity_factor);
}

/// Completes the law with the values that follow from its curves.
WaterLaw finish(WaterLaw law);

/// Content m_w/(ρ_w V_pores) [-] at the pressure `p` [Pa].
double find_content(const WaterLaw& law, double pressure);

/// Storage -∂(S ρ_w/ρ_w)/∂p per pore volume, S/K_w - dS/dp [1/Pa].
double find_storage(const WaterLaw& law, double pressure);

// State of pore water at a known pressure, here and on a GPU.

/// χ of Khalili and Khabbaz (1998) above the air entry [-].
template <class T>
TALUS_KERNEL T find_suction_share(const WaterLaw& law, T pressure) {
  return lane_power(lane_max(T(1.0), pressure * (1 / law.chi_air_entry)), -0.55);
}

/// Pore-pressure term χp of the total stress [Pa].
template <class T>
TALUS_KERNEL T find_bishop(const WaterLaw& law, T pressure, T saturation) {
  if (law.chi_air_entry <= 0) return saturation * pressure;
  return find_suction_share(law, pressure) * pressure;
}

/// k_r [-]. The slope is not needed; inlining removes its computation.
template <class T>
TALUS_KERNEL T find_relative(const WaterLaw& law, const material::SoilWater<T>& water) {
  return visit_kind(
      [&](const auto& l) {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, material::Mualem>) {
          if (l.same_curve && !any(water.complement < T(0.0))) return l.find_value(water);
        }
        return T(l.evaluate(water).value);
      },
      law.relative);
}

template <class T>
TALUS_PORTABLE PoreState<T> find_state_at_pressure(const WaterLaw& law, T pressure) {
  const material::SoilWater<T> water = material::find_water(law.retention, pressure);
  const double inverse = 1 / law.bulk_modulus;
  return {pressure, water.saturation, find_bishop(law, pressure, water.saturation),
          lane_max(find_relative(law, water), T(lowest_relative_conductivity)),
          (water.slope - water.saturation * inverse) * lane_exp(pressure * -inverse)};
}

/// Bishop's χ [-] at a pressure and its saturation.
template <class T>
TALUS_KERNEL T find_chi(const WaterLaw& law, T pressure, T saturation) {
  return law.chi_air_entry <= 0 ? saturation : find_suction_share(law, pressure);
}

}  // namespace talus::mpm
