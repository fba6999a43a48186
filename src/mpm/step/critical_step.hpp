// SPDX-License-Identifier: MIT
#pragma once
// The largest stable time step.

#include "mpm/step/step.hpp"

namespace talus::mpm {

/// Largest stable step [s] for Courant number 1: the smallest over the elements that hold points and their neighbours.
struct CriticalStep {
  double dt = 0;
  int element = -1;
};

/// One phase (2.84): altitude / √(E_c/(βρ)), with the density of the points of the element.
template <int D>
CriticalStep find_critical_step(const Body<D>& body, double mass_scaling);

/// The same, and with pore water (2.85-2.88) as page 14 has them: a/β, b/β, c/β², without a when the drag is implicit.
/// Soil near saturation counts as saturated, since it may be so before the next look.
template <int D>
CriticalStep find_critical_step(const Body<D>& body, const StepOptions<D>& options);

/// What (2.85) needs of a soil and its water.
struct CoupledSoil {
  double constrained_modulus;           ///< E_c [Pa]
  double porosity, saturation;          ///< [-]
  double storage;                       ///< n (S/K_w - dS/dp) [1/Pa]
  double grain_density, water_density;  ///< [kg/m³]
  double resistance;                    ///< ρ_w g/k [N s/m⁴]
};

/// (2.85) [s] for an element of the altitude `length` [m].
double find_two_velocity_step(const CoupledSoil& soil, double length, double mass_scaling, bool implicit_drag);

}  // namespace talus::mpm
