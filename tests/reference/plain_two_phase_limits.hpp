// SPDX-License-Identifier: MIT
#pragma once
// Critical time steps of the coupled step (2.84–2.88): the source's sufficient bound, and the exact limit of the
// one-dimensional scheme for explicit and implicit drag.

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
  /// Of the strains of solid and water: the pressure rises by S[(1−n) ε_s + n ε_w]/storage.
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
inline double critical_step(const CoupledSoil& soil, double length, double beta, Drag drag) {
  const Eigen::Vector2d m = soil.mass();
  const Eigen::Matrix2d k = soil.stiffness();
  const double a = drag == Drag::implicit_at_nodes ? 0.0 : soil.drag() * (1 / m[0] + 1 / m[1]) / beta;  // (2.86)
  const double b = 4 / (length * length) * (k(0, 0) / m[0] + k(1, 1) / m[1]) / beta;                    // (2.87)
  const double c = 16 / std::pow(length, 4) * k.determinant() / (m[0] * m[1]) / (beta * beta);          // (2.88)
  const double x = b + std::sqrt(b * b - 4 * c);
  return (-2 * a + std::sqrt(4 * a * a + 8 * x)) / x;
}

/// The smallest Δt with det(4βM − Δt²λK ∓ 2Δt C) = 0, λ = 4/L², minus for explicit and plus for implicit drag: where
/// the mode that changes its sign in every step of the 1-D scheme neither grows nor decays.
inline double exact_critical_step(const CoupledSoil& soil, double length, double beta, Drag drag) {
  const auto smallest_eigenvalue = [&](double dt) {
    Eigen::Matrix2d c;
    c << 1, -1, -1, 1;
    c *= soil.drag() * 2 * dt * (drag == Drag::implicit_at_nodes ? 1 : -1);
    const Eigen::Matrix2d m = 4 * beta * soil.mass().asDiagonal().toDenseMatrix();
    const Eigen::Matrix2d s = m - dt * dt * 4 / (length * length) * soil.stiffness() + c;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(s).eigenvalues()[0];
  };
  double low = 0, high = 1e-12;
  while (smallest_eigenvalue(high) > 0) low = high, high *= 1.5;
  for (int i = 0; i < 80; ++i) (smallest_eigenvalue((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace talus::reference
