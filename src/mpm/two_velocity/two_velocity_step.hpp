// SPDX-License-Identifier: MIT
#pragma once
// What the node loops of the coupled step share.

#include "mpm/step/step.hpp"
#include "mpm/two_velocity/water_surface.hpp"

namespace talus::mpm {

/// What does not change from node to node.
template <int D>
struct NodePass {
  Body<D>& body;
  const StepOptions<D>& options;
  double density;  ///< ρ_w [kg/m³]
  Vec<D> up;       ///< unit, against gravity

  NodePass(Body<D>& b, const StepOptions<D>& o)
      : body(b), options(o), density(b.water.density), up(find_up<D>(o.gravity)) {}
};

// The lines of the step of soil and pore water (docs/theory/14-two-phase.md), over the points, elements and kernels of
// one phase. step() of step.hpp runs them for bodies with water.

// The lines of the step, in order.

/// Open sides, and the forces of outer water on them (3.11). Writes load, darcy_load, facing, suction.
template <int D>
void load_surface(Body<D>& body, const StepOptions<D>& options);

/// Accelerations of both phases (2.66, 2.67, 2.89-2.91), with inflow limited. Reads sums; writes motion, work, monitor.
template <int D>
void solve_momentum(Wet, Body<D>& body, const StepOptions<D>& options);

/// Velocities of both phases (2.78, 2.79), the flux between them, and the budget of the water. Zeroes sums.
template <int D>
void remap_momentum(Wet, Body<D>& body, const StepOptions<D>& options);

/// Nodal averages of the strain increment and of the divergence (2.94), and the surplus of pressure smoothing (2.96).
template <int D>
void smooth_increments(Wet, Body<D>& body, const StepOptions<D>& options);

/// Water is exchanged, and drawn by roots, in every so many steps.
inline constexpr int exchange_interval = 4;

/// Whether this step's surplus holds anything.
template <int D>
bool has_surplus(const Body<D>& body, const StepOptions<D>& o) {
  const bool moves_water = o.exchange_water || !body.water.uptakes.empty();
  return o.smooth_pressure || (moves_water && body.step_count % exchange_interval == 0);
}

/// Adds to the surplus what neighbouring elements exchange (T14.9).
template <int D>
void exchange_water(Body<D>& body, const StepOptions<D>& options);

/// Everything that happens to the points (2.76, 2.77, 2.80-2.83, 3.4), and the nodal sums of the next step.
template <int D>
MoverLists advance_points(Wet, Body<D>& body, const StepOptions<D>& options);

/// Adds to the budgets what the chunks of all ranks have counted in a step, [chunk][surface].
template <int D>
void add_budgets(Body<D>& body, std::vector<SurfaceBudget>& by_chunk);

// Single elements, for the few that relocation touches and for a fresh start.

/// Adds `sign` times everything that element `e` gives to its nodes, from the points that are in it now and as it was
/// integrated last (Water::stretch). With sign > 0 also takes its moments and means anew.
template <int D>
void add_wet_element(Body<D>& body, int e, const StepOptions<D>& options, double sign);

/// Forces of the pore water on the mixture, by node [N]: -Σ V̄ χ p ∇N, and the pressure of the water outside. Reads what
/// gather_nodal_sums() or a pass has left.
template <int D>
std::vector<Vec<D>> find_pore_force(Body<D>& body, const StepOptions<D>& options);

/// The directions in which each phase is held, for all nodes, from the conditions.
template <int D>
void find_held_axes(Body<D>& body);

/// Decides how element `e` is integrated; when it is full, its points share their water and its pressure.
template <int D>
void share_wet_element(Body<D>& body, int e, const StepOptions<D>& options);

}  // namespace talus::mpm
