// SPDX-License-Identifier: MIT
#pragma once
// The state of pore water at a pressure that is known, here and on a GPU.

#include <cmath>

#include "mpm/coupled/pore_state.hpp"

namespace talus::mpm {

/// χ of Khalili and Khabbaz (1998) beyond the air entry.
template <class T>
TALUS_KERNEL T find_suction_share(const WaterLaw& law, T pressure) {
  return lane_power(lane_max(T(1.0), pressure * (1 / law.chi_air_entry)), -0.55);
}

/// χ p.
template <class T>
TALUS_KERNEL T find_bishop(const WaterLaw& law, T pressure, T saturation) {
  if (law.chi_air_entry <= 0) return saturation * pressure;
  return find_suction_share(law, pressure) * pressure;
}

/// k_r; its slope is not wanted, and is not calculated when the law is inlined.
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

/// χ of Bishop's stress at a pressure and its saturation [-].
TALUS_PORTABLE inline double find_chi(const WaterLaw& law, double pressure, double saturation) {
  return law.chi_air_entry <= 0 ? saturation : find_suction_share(law, pressure);
}

}  // namespace talus::mpm
