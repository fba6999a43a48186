// SPDX-License-Identifier: MIT
#pragma once
// Phases of the step in the Darcy (u-p) formulation (docs/theory/22-mixture.md): soil and pore water with one velocity,
// and nodal pressures solved for implicitly. Grid solve, remap, G2P and P2G are those of one phase, with the mass of
// soil and water; step() of step.hpp runs the step for bodies with water when StepOptions::darcy is set.

#include "mpm/state/body.hpp"

namespace talus::mpm {

struct Darcy {
  static constexpr bool has_water = true;
};

/// Computes the contents of elements and nodes, and the pressures that the step starts from. Writes darcy.pores,
/// volume, water, node_pores, node_water, pressure, and water.volume, stretch, mean_pressure, mean_saturation.
template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& options);

/// Computes the coefficients of the flow at these pressures. Writes darcy.saturated … soft.
template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& options);

/// Forces of tractions and of outside water. Writes nodes.load.
template <int D>
void load_darcy(Body<D>& body, const StepOptions<D>& options);

/// Adds the forces of the pore pressures to the nodal sums, in place of those added before. Writes darcy.pore_force.
template <int D>
void press_nodes(Body<D>& body, const StepOptions<D>& options);

/// Power of the pressure forces with the nodal velocities [W].
template <int D>
double find_pore_power(const Body<D>& body, const StepOptions<D>& options);

/// Predicted motion v* (T22.3), after solve_momentum() with the pressures at the start. Writes darcy.velocity,
/// acceleration, mobility.
template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& options);

/// Solves for the pressures at the end of the step (T22.5), and computes the water that leaves each node and each pore,
/// root uptake included. Writes darcy.change, out, passed, share, flux and pressure, water.budgets, transpired,
/// mean_pressure.
template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& options);

/// Ends the run with an error: the pressures of step number `step` did not converge.
[[noreturn]] void throw_no_pressures(std::int64_t step);

/// G2P, and the P2G of the next step, in one pass over the points.
template <int D>
MoverLists advance_points(Darcy, Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
