// SPDX-License-Identifier: MIT
#pragma once
// The largest stable time step.

#include "mpm/solver/step.hpp"

namespace talus::mpm {

/// Largest stable step [s] for Courant number 1: the minimum over the elements that hold points and their neighbours
/// (T3.1).
struct CriticalStep {
  double dt = 0;
  int element = -1;
};

/// One phase (2.84): altitude / √(E_c/(βρ)), with ρ = m_p/V_p of the points of the element.
template <int D>
CriticalStep find_critical_step(const Body<D>& body, double mass_scaling);

/// With pore water also (2.85-2.88) in the form of theory 14: a/β, b/β, c/β², and a = 0 for implicit drag. Soil near
/// saturation counts as saturated, since it may be so before the next evaluation.
template <int D>
CriticalStep find_critical_step(const Body<D>& body, const StepOptions<D>& options);

/// Properties of a soil and its water that enter (2.85).
struct CoupledSoil {
  double constrained_modulus;           ///< E_c [Pa]
  double porosity, saturation;          ///< [-]
  double storage;                       ///< n (S/K_w - dS/dp) [1/Pa]
  double grain_density, water_density;  ///< [kg/m³]
  double resistance;                    ///< ρ_w g/k [N s/m⁴]
};

/// Critical step (2.85) [s] of an element of altitude `length` [m].
double find_two_velocity_step(const CoupledSoil& soil, double length, double mass_scaling, bool implicit_drag);

}  // namespace talus::mpm
