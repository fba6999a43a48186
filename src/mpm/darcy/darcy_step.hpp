// SPDX-License-Identifier: MIT
#pragma once
// The lines of the step of the mixture (docs/theory/22-mixture.md): soil and pore water with one velocity, and
// pressures at the nodes that are solved for. The lines of one phase do the rest, on masses of soil and water together;
// step() of step.hpp runs them all for bodies with water when StepOptions::mixture.

#include "mpm/step/step.hpp"

namespace talus::mpm {

struct Darcy {
  static constexpr bool has_water = true;
};

/// What elements and nodes hold, and the pressures that the step starts from. Writes mixture.pores, volume, water,
/// node_pores, node_water, pressure, and water.volume, stretch, mean_pressure, mean_saturation.
template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& options);

/// Coefficients of the flow at these pressures. Writes mixture.saturated … soft.
template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& options);

/// Forces of tractions and of the water outside. Writes nodes.load.
template <int D>
void load_darcy(Body<D>& body, const StepOptions<D>& options);

/// Puts the forces of the pore pressures into the sums of the nodes, in place of those that are there. Writes
/// mixture.pore_force.
template <int D>
void press_nodes(Body<D>& body, const StepOptions<D>& options);

/// Power of these forces with the velocities of the nodes [W].
template <int D>
double find_pore_power(const Body<D>& body, const StepOptions<D>& options);

/// What solve_momentum() makes of the velocities, as far as the points see it. Writes mixture.velocity, acceleration,
/// mobility.
template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& options);

/// The pressures of the end of the step (T22.5), and the water that leaves every node and every pore, what roots draw
/// included. Writes mixture.change, out, passed, share, flux and pressure, water.budgets, transpired, mean_pressure.
template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& options);

/// The end of a run whose pressures of `step` were not found.
[[noreturn]] void throw_no_pressures(std::int64_t step);

/// Everything that happens to the points, and the nodal sums of the next step.
template <int D>
MoverLists advance_points(Darcy, Body<D>& body, const StepOptions<D>& options);

/// The step.
template <int D>
void step_darcy(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
