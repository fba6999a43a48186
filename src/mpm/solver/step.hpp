// SPDX-License-Identifier: MIT
#pragma once
// The computational cycle of MPM (MUSL, section 2.2.3 of the source; theory 2): grid solve, P2G and G2P, rearranged so
// that the points are read and written once per step.
//
// On linear simplices the update of a point is affine in its local coordinates. The second mapping of MUSL, Σ_p N_i m_p
// (v_p + Δt Σ_j N_j a_j) = p_i + Δt Σ_j M_ij a_j (T2.3), therefore needs no second pass over the points: M is the
// element's consistent mass matrix, computed from the moments (T2.4) that the one pass sums. tests/reference has the
// textbook order.

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Advances the body by one step. Reads the nodal sums of the last pass over the points, writes those of the next step.
template <int D>
void step(Body<D>& body, const StepOptions<D>& options);

/// Tag of the phases of the step for soil of one phase. The others are Wet (two_velocity/two_velocity_step.hpp) and
/// Darcy (darcy/darcy_step.hpp).
struct Dry {
  static constexpr bool has_water = false;
};

// The phases of the step, in order.

/// Grid solve: a_i = (f_ext - f_int + f_damp)_i / (β m_i) with constraints (2.39, 2.89). Reads sums; writes motion (a),
/// work, monitor.
template <int D>
void solve_momentum(Dry, Body<D>& body, const StepOptions<D>& options);

/// Grid solve, second mapping of MUSL: v_i = (p_i + Δt Σ_j M_ij a_j) / m_i with constraints (2.41). Reads motion (a)
/// and moments; writes motion (v), zeroes sums.
template <int D>
void remap_momentum(Dry, Body<D>& body, const StepOptions<D>& options);

/// Nodal averages of the volumetric strain increment (2.94); with smoothing "stable" the plastic dilation of the last
/// step is subtracted before averaging (T4.4). Reads motion (v), plastic_dilation; writes smoothed.
template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& options);

/// G2P and the P2G of the next step in one pass: v_p, ξ_p, Δε_p, σ_p, V_p (2.40, 2.42-2.45), then the nodal sums (2.35,
/// 2.38).
template <int D>
MoverLists advance_points(Dry, Body<D>& body, const StepOptions<D>& options);

/// Moves the points that left their element, and their part of the nodal sums, to their new element. The order does not
/// depend on the number of threads. Points that left the grid are recorded in `lost`.
template <int D>
void relocate(Body<D>& body, const StepOptions<D>& options, const MoverLists& movers);

/// Filters null modes between steps (T2.5): removes the components of the point velocities that have no momentum at any
/// node. Reads and writes the nodal sums of momentum. Conserves linear momentum exactly; the kinetic energy removed is
/// added to work.mapping.
template <int D>
void filter_null_modes(Body<D>& body, const StepOptions<D>& options);

/// Computes the nodal sums from scratch (P2G), at the start of a stage, when the options of the internal force may have
/// changed.
template <int D>
void gather_nodal_sums(Body<D>& body, const StepOptions<D>& options);

// The largest stable time step.

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
