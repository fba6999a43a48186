// SPDX-License-Identifier: MIT
#pragma once
// Grid solve and remap of free nodes (without constraint, and in one chunk only), one pack of nodes at once. They are
// most nodes of a body; solve_nodes() and remap_nodes() do the others, and give bitwise identical motion.

#include "base/rows.hpp"
#include "mpm/kernels/grid_solve_kernels.hpp"

namespace talus::mpm {

/// The pack of nodes that starts at `first`.
struct NodeRows {
  int rows[lane_width];  ///< the first row of each node
  bool all_free = true;

  template <int D>
  TALUS_KERNEL NodeRows(const Body<D>& body, int first) {
    const Layout<D>& layout = *body.layout;
    for (int l = 0; l < lane_width; ++l) {
      const int i = first + l, start = layout.row_start[i];
      rows[l] = layout.node_rows[start];
      all_free = all_free && layout.row_start[i + 1] - start == 1 && body.conditions.constraint_of_node[i] < 0;
    }
  }
};

/// Sums and motion of a pack of nodes.
template <int D>
struct NodePackState {
  Pack sums[1 + 2 * D], motion[2 * D];
  Pack mass;  ///< 1 where the node has none [kg]
  Mask some;  ///< the node has mass

  TALUS_KERNEL NodePackState(const Body<D>& body, const NodeRows& nodes) {
    load_rows<1 + 2 * D, sums_stride>(body.nodes.sums.data(), nodes.rows, sums);
    load_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), nodes.rows, motion);
    some = sums[0] > Pack(1e-12 * body.smallest_mass);
    mass = select(some, sums[0], Pack(1.0));
  }
};

/// Accelerations of a pack of free nodes. `works` receives damping work and mapping loss by lane [J].
template <int D>
TALUS_KERNEL void solve_free_nodes(Body<D>& body, const StepOptions<D>& o, const NodeRows& nodes, Pack (&works)[2]) {
  NodePackState<D> at(body, nodes);
  const Pack inverse_mass = 1.0 / at.mass, inverse = inverse_mass * (1 / o.mass_scaling), zero(0.0);
  Pack lost(0.0), braked(0.0);
  TALUS_UNROLL
  for (int d = 0; d < D; ++d) {
    const Pack p = at.sums[1 + d], inner = at.sums[1 + D + d], f = inner + round_lanes(at.sums[0] * o.gravity[d]);
    const Pack size = lane_abs(f) * o.damping;
    const Pack brake = select(p > zero, -size, select(p < zero, size, zero));
    const Pack a = (f + brake) * inverse;
    lost += body.nodes.motion_step * (at.motion[D + d] * inner) - o.dt * (a * p);
    braked -= brake * (p * inverse_mass + 0.5 * o.dt * a);
    at.motion[d] = select(at.some, a, zero);
  }
  braked *= o.dt;
  works[0] += select(at.some, braked, zero);
  works[1] += select(at.some, 0.5 * lost - braked, zero);
  store_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), nodes.rows, at.motion);
}

/// Velocities of a pack of free nodes after the remap; zeroes their sums. `works` receives external work and
/// mapping loss, over Δt and by lane [W].
template <int D>
TALUS_KERNEL void remap_free_nodes(Body<D>& body, const StepOptions<D>& o, const NodeRows& nodes, Pack (&works)[2]) {
  NodePackState<D> at(body, nodes);
  const Pack inverse = 1.0 / at.mass, zero(0.0);
  Pack lost(0.0), work(0.0);
  TALUS_UNROLL
  for (int d = 0; d < D; ++d) {
    const Pack p = at.sums[1 + d], v = select(at.some, p * inverse, zero);
    lost += at.sums[1 + D + d] * v - at.motion[d] * p;
    work += at.sums[0] * o.gravity[d] * v;
    at.motion[D + d] = v;
  }
  works[0] += select(at.some, work, zero);
  works[1] += select(at.some, 0.5 * lost + work, zero);
  store_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), nodes.rows, at.motion);
  for (int l = 0; l < lane_width; ++l) {
    double* row = &body.nodes.sums[static_cast<std::size_t>(nodes.rows[l]) * sums_stride];
    TALUS_UNROLL
    for (int q = 0; q < sums_stride; ++q) row[q] = 0;
  }
}

/// Calls solve(nodes) for the packs of the nodes [begin, end) that are free, and solve_others(first, last) for the
/// nodes between them.
template <int D, class Solve, class SolveOthers>
TALUS_KERNEL void for_node_packs(const Body<D>& body, int begin, int end, Solve&& solve, SolveOthers&& solve_others) {
  int first = begin;
  for (int i = begin; i + lane_width <= end; i += lane_width) {
    const NodeRows nodes(body, i);
    if (!nodes.all_free) continue;
    if (first < i) solve_others(first, i);
    solve(nodes);
    first = i + lane_width;
  }
  if (first < end) solve_others(first, end);
}

}  // namespace talus::mpm
