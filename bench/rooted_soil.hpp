// SPDX-License-Identifier: MIT
#pragma once
// The rooted-soil model on the slope of the yardstick. Its largest stiffness equals that of the Mohr–Coulomb soil, and
// its strength is low enough for the slope to fail, so that the mix of elastic, hardening and softening points is that
// of a slide.

#include <algorithm>
#include <vector>

#include "material/every_law.hpp"
#include "mpm/solver/build.hpp"

namespace talus::bench {

/// Returns the law, and sets the state of each point at its stress. `modulus` is the largest constrained modulus [Pa].
template <int D>
material::RootedCamClay plant_roots(std::vector<mpm::InitialPoint<D>>& points, double modulus, double poisson) {
  const auto pressure = [](const mpm::InitialPoint<D>& p) { return -(p.stress[0] + p.stress[1] + p.stress[2]) / 3; };
  double highest = 1e3;
  for (const auto& p : points) highest = std::max(highest, pressure(p));
  constexpr double void_ratio = 0.6, preconsolidation_ratio = 1.3, content = 1;
  material::CamClayParameters soil;
  soil.poisson_ratio = poisson;
  soil.swelling = (1 + void_ratio) * highest / (modulus * (1 + poisson) / (3 * (1 - poisson)));
  soil.compression = 4 * soil.swelling;
  soil.critical_state_slope = 0.8;
  soil.suction_hardening = 10;
  const material::RootedCamClay law(soil, {.hardening = 0.4, .strength = 0.18});
  for (auto& p : points) {
    const double preconsolidation = preconsolidation_ratio * std::max(pressure(p), soil.smallest_pressure);
    law.set_initial_state(p.stress.data(), void_ratio, content, preconsolidation, 1, p.state.data());
  }
  return law;
}

}  // namespace talus::bench
