// SPDX-License-Identifier: MIT
#pragma once
// From the water that pores hold to its pressure, the stress that it makes and how easily it flows.

#include "mpm/coupled/water.hpp"

namespace talus::mpm {

/// Below this share of the saturated conductivity water counts as immobile; zero would be an infinite drag.
inline constexpr double lowest_relative_conductivity = 1e-12;

template <class T>
struct PoreState {
  T pressure;    ///< p, tension positive [Pa]
  T saturation;  ///< S [-]
  T bishop;      ///< χ p, its share in the total stress [Pa]
  T relative;    ///< k_r, at least lowest_relative_conductivity [-]
  T capacity;    ///< d content/dp, negative [1/Pa]
};

using talus::select;
template <class T>
TALUS_KERNEL PoreState<T> select(MaskOf<T> c, const PoreState<T>& a, const PoreState<T>& b) {
  return {select(c, a.pressure, b.pressure), select(c, a.saturation, b.saturation), select(c, a.bishop, b.bishop),
          select(c, a.relative, b.relative), select(c, a.capacity, b.capacity)};
}

/// The pressure at which pores hold `content` = m_w/(ρ_w V_pores) [-]: S(p) e^(-p/K_w) = content (T14.7), from `guess`
/// [Pa]. A guess that follows the last state by its capacity is right to second order, and one look at the retention
/// curve is enough then. Lanes that are not active are left without meaning.
template <class T>
PoreState<T> find_pore_state(const WaterLaw& law, T content, T guess, MaskOf<T> active);

/// The same for a pressure that is known.
template <class T>
TALUS_PORTABLE PoreState<T> find_state_at_pressure(const WaterLaw& law, T pressure);

/// ρ_w g/k of the saturated soil: force per volume and Darcy's flux [N s/m⁴].
TALUS_PORTABLE inline double find_saturated_resistance(const WaterLaw& law, double conductivity_factor) {
  return law.density * law.drag_gravity / (law.conductivity * conductivity_factor);
}

/// The law with what follows from its curves.
WaterLaw finish(WaterLaw law);

/// m_w/(ρ_w V_pores) [-] at the pressure `p` [Pa].
double find_content(const WaterLaw& law, double pressure);

/// Storage -∂(S ρ_w/ρ_w)/∂p per pore volume, S/K_w - dS/dp [1/Pa].
double find_storage(const WaterLaw& law, double pressure);

}  // namespace talus::mpm
