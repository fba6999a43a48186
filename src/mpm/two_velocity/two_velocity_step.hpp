// SPDX-License-Identifier: MIT
#pragma once
// The step of soil and pore water in the two-velocity formulation (v_s-v_w; theory 14): its phases (grid solve, G2P,
// P2G) beside those of one phase, and the data that its node loops share. step() of step.hpp runs it for bodies with
// water.

#include "mpm/kernels/water_surface.hpp"
#include "mpm/pore_water/surface.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Tag of the phases of the step for soil and pore water with two velocities.
struct Wet {
  static constexpr bool has_water = true;
};

/// Data that are constant over the nodes of a step.
template <int D>
struct NodePass {
  Body<D>& body;
  const StepOptions<D>& options;
  double density;  ///< ρ_w [kg/m³]
  Vec<D> up;       ///< unit vector against gravity

  NodePass(Body<D>& b, const StepOptions<D>& o)
      : body(b), options(o), density(b.water.density), up(find_up<D>(o.gravity)) {}
};

// The phases of the step, in order.

/// Grid solve: accelerations of both phases (2.66, 2.67, 2.89-2.91), with inflow limited (T14.11). Reads sums; writes
/// motion, work, monitor.
template <int D>
void solve_momentum(Wet, Body<D>& body, const StepOptions<D>& options);

/// Grid solve, second mapping of MUSL: velocities of both phases (2.78, 2.79), the flux between them, and the water
/// budget. Zeroes sums.
template <int D>
void remap_momentum(Wet, Body<D>& body, const StepOptions<D>& options);

/// Nodal averages of the strain increment and of the divergence (2.94), and the surplus of pressure smoothing (2.96).
template <int D>
void smooth_increments(Wet, Body<D>& body, const StepOptions<D>& options);

/// Returns whether the surplus is nonzero in this step.
template <int D>
bool has_surplus(const Body<D>& body, const StepOptions<D>& o) {
  const bool moves_water = o.exchange_water || !body.water.uptakes.empty();
  return o.smooth_pressure || (moves_water && body.step_count % exchange_interval == 0);
}

/// Adds the water that neighbouring elements exchange (T14.9) to the surplus.
template <int D>
void exchange_water(Body<D>& body, const StepOptions<D>& options);

/// G2P (2.76, 2.77, 2.80-2.83, 3.4) and the P2G of the next step, in one pass over the points.
template <int D>
MoverLists advance_points(Wet, Body<D>& body, const StepOptions<D>& options);

// Single elements, for relocation and for the start of a stage.

/// Adds `sign` times the contribution of element `e` to its node rows, from the points that it holds now, integrated as
/// last time (Water::stretch). With sign > 0, its moments and means are recomputed as well.
template <int D>
void add_wet_element(Body<D>& body, int e, const StepOptions<D>& options, double sign);

/// Forces of pore water on the mixture, by node [N]: -Σ V̄ χ p ∇N and the pressure of outside water. Reads the results
/// of gather_nodal_sums() or of a pass.
template <int D>
std::vector<Vec<D>> find_pore_force(Body<D>& body, const StepOptions<D>& options);

/// Computes, from the conditions, the directions in which each phase is fixed, for all nodes.
template <int D>
void find_held_axes(Body<D>& body);

/// Determines how element `e` is integrated. The points of a full element share their water and its pressure.
template <int D>
void average_wet_element(Body<D>& body, int e, const StepOptions<D>& options);

}  // namespace talus::mpm
