// SPDX-License-Identifier: MIT
#pragma once
// Critical time steps of the two-velocity formulation (2.84–2.88): the sufficient bound of the source, and the exact
// limit of the one-dimensional scheme for explicit and implicit drag.

#include <Eigen/Dense>
#include <cmath>

#include "reference/plain_two_phase_momentum.hpp"

namespace talus::reference {

/// One soil at one state. `storage` is −∂(water volume per volume)/∂p: n/K_w when saturated, n(S/K_w − dS/dp) else.
struct CoupledSoil {
  double constrained_modulus;  ///< E_c [Pa]
  double porosity, saturation, storage;
  double grain_density, water_density;  ///< [kg/m³]
  double conductivity, drag_gravity;    ///< k(S) [m/s], [m/s²]

  static CoupledSoil saturated(double modulus, double n, double bulk_modulus, double grains, double k) {
    return {modulus, n, 1.0, n / bulk_modulus, grains, 1000.0, k, 9.81};
  }
  Eigen::Vector2d mass() const { return {(1 - porosity) * grain_density, porosity * saturation * water_density}; }
  /// Stiffness for the strains of solid and water: the pressure rises by S[(1−n) ε_s + n ε_w]/storage.
  Eigen::Matrix2d stiffness() const {
    const Eigen::Vector2d to_pressure(saturation * (1 - porosity), saturation * porosity);
    Eigen::Matrix2d k = to_pressure * to_pressure.transpose() / storage;
    k(0, 0) += constrained_modulus;
    return k;
  }
  /// θ² ρ_w g/k: force per volume and relative velocity [kg/(m³ s)].
  double drag() const {
    const double theta = porosity * saturation;
    return theta * theta * water_density * drag_gravity / conductivity;
  }
  /// √((E_c + S²/storage)/ρ), (2.100) [m/s].
  double undrained_wave_speed() const {
    return std::sqrt((constrained_modulus + saturation * saturation / storage) / mass().sum());
  }
};

/// (2.85) with a/β, b/β, c/β². Implicit drag: a = 0, the drag does not shorten the step.
double critical_step(const CoupledSoil& soil, double length, double beta, Drag drag);

/// The smallest Δt with det(4βM − Δt²λK ∓ 2Δt C) = 0, λ = 4/L², minus for explicit and plus for implicit drag: where
/// the mode that changes its sign in every step of the 1-D scheme neither grows nor decays.
double exact_critical_step(const CoupledSoil& soil, double length, double beta, Drag drag);

}  // namespace talus::reference
