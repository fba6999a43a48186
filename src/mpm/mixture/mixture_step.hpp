// SPDX-License-Identifier: MIT
#pragma once
// The lines of the step of the mixture (docs/theory/22-mixture.md): soil and pore water with one velocity, and
// pressures at the nodes that are solved for. The lines of one phase do the rest, on masses of soil and water together;
// step() of step.hpp runs them all for bodies with water when StepOptions::mixture.

#include "mpm/step/step.hpp"

namespace talus::mpm {

struct Mixture {
  static constexpr bool has_water = true;
};

/// What elements and nodes hold, and the pressures that the step starts from. Writes mixture.pores, volume, water,
/// node_pores, node_water, pressure, and water.volume, stretch, mean_pressure, mean_saturation.
template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& options);

/// Coefficients of the flow at these pressures. Writes mixture.saturated … soft.
template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& options);

/// Forces of tractions, of the water outside and of pore pressures at the nodes. Writes nodes.load.
template <int D>
void load_mixture(Body<D>& body, const StepOptions<D>& options, const std::vector<double>& pressure);

/// What solve_momentum() makes of the velocities. Writes mixture.velocity, acceleration, mobility.
template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& options);

/// The pressures of the end of the step (T22.4), and the water that leaves every node and every pore. Writes
/// mixture.change, out, passed, share and pressure, water.budgets, mean_pressure.
template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& options);

/// Everything that happens to the points, and the nodal sums of the next step.
template <int D>
MoverLists advance_points(Mixture, Body<D>& body, const StepOptions<D>& options);

/// The step.
template <int D>
void step_mixture(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
