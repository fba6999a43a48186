// SPDX-License-Identifier: MIT
// The step of MPM as the sequence of its phases: grid solve, remap, smoothing, G2P and P2G, relocation, loads.
#include "mpm/solver/step.hpp"

#include "base/rows.hpp"
#include "mpm/backend/chunk_pass.hpp"
#include "mpm/darcy/darcy_step.hpp"
#include "mpm/kernels/averages.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/free_node_kernels.hpp"
#include "mpm/kernels/g2p_p2g_kernels.hpp"
#include "mpm/kernels/grid_solve_kernels.hpp"
#include "mpm/solver/bars.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"
#include "mpm/state/partition.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {

namespace {

/// Runs the phases of the step in order and adds the time of each to its part of body.timing. MUSL's grid solve is
/// solve_momentum and remap_momentum; advance_points is G2P and the P2G of the next step.
template <class Phase, int D>
void run_phases(Phase phase, Body<D>& body, const StepOptions<D>& o, Stopwatch timed) {
  using input::Smoothing;
  constexpr bool wet = Phase::has_water;
  const bool exchanges = wet && body.step_count % exchange_interval == 0;
  Timing& t = body.timing;
  MoverLists movers;
  if (wet) timed(t.solve_momentum, [&] { load_surface(body, o); });
  timed(t.solve_momentum, [&] { solve_momentum(phase, body, o); });
  timed(t.remap_momentum, [&] { remap_momentum(phase, body, o); });
  if (o.smoothing != Smoothing::none || (wet && o.smooth_pressure))
    timed(t.smooth_strain, [&] { smooth_increments(phase, body, o); });
  if (exchanges && o.exchange_water) timed(t.smooth_strain, [&] { exchange_water(body, o); });
  if (exchanges && !body.water.uptakes.empty()) timed(t.smooth_strain, [&] { draw_root_water(body, o); });
  timed(t.advance_points, [&] { movers = advance_points(phase, body, o); });
  body.time += o.dt;
  ++body.step_count;
  timed(t.relocate, [&] { relocate(body, o, movers); });
  timed(t.relocate, [&] {
    advance_bars(body, o);
    gather_loads(body);
  });
}

/// The step of the Darcy formulation (theory 22): contents and coefficients, pressure solve between two grid solves,
/// then the remap and the pass over the points of one phase.
template <int D>
void run_darcy_phases(Body<D>& body, const StepOptions<D>& o) {
  Stopwatch timed;
  Timing& t = body.timing;
  MoverLists movers;
  timed(t.solve_momentum, [&] {
    find_contents(body, o);
    load_surface(body, o);
    find_flow(body, o);
    load_darcy(body, o);
    press_nodes(body, o);
    const Work before = body.work;
    solve_momentum(Dry{}, body, o);
    body.work = before;  // work is counted with the pressures of the end of the step
    predict_motion(body, o);
    solve_pressures(body, o);
    press_nodes(body, o);
    solve_momentum(Dry{}, body, o);
    body.work.pore_water -= 0.5 * body.nodes.motion_step * find_pore_power(body, o);  // mean of the step (T9.1)
  });
  timed(t.remap_momentum, [&] {
    remap_momentum(Dry{}, body, o);
    body.work.pore_water -= 0.5 * o.dt * find_pore_power(body, o);
  });
  if (o.smoothing != input::Smoothing::none) timed(t.smooth_strain, [&] { smooth_increments(Dry{}, body, o); });
  timed(t.advance_points, [&] { movers = advance_points(Darcy{}, body, o); });
  body.time += o.dt;
  ++body.step_count;
  timed(t.relocate, [&] {
    relocate(body, o, movers);
    advance_bars(body, o);
  });
}

}  // namespace

template <int D>
void step(Body<D>& body, const StepOptions<D>& options) {
  if (body.water.is_wet() && options.darcy)
    run_darcy_phases(body, options);
  else if (body.water.is_wet())
    run_phases(Wet{}, body, options, {});
  else
    run_phases(Dry{}, body, options, {});
}

template void step<2>(Body<2>&, const StepOptions<2>&);
template void step<3>(Body<3>&, const StepOptions<3>&);

// G2P and P2G for soil of one phase: the pass over the points with the hooks of DryBlock.

namespace {

template <int D>
struct DryPass : OneVelocityPass<D> {
  template <class Law>
  using Block = DryBlock<DryPass, Law>;
  using OneVelocityPass<D>::OneVelocityPass;

  TALUS_KERNEL void note_full(const BlockPlace<Body<D>>&, Mask) {}
};

}  // namespace

template <int D>
MoverLists advance_points(Dry, Body<D>& body, const StepOptions<D>& options) {
  return advance_blocks<DryPass<D>>(body, options);
}

template MoverLists advance_points<2>(Dry, Body<2>&, const StepOptions<2>&);
template MoverLists advance_points<3>(Dry, Body<3>&, const StepOptions<3>&);

// Grid solve: nodal accelerations, then the nodal velocities of MUSL's second mapping (remap).

template <int D>
void solve_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  const bool by_packs = !o.monitor && body.nodes.load.empty();
  solve_pieces(body, o.threads, body.nodes.sums, sums_stride, o.monitor, [&](int begin, int end, PieceSums& sums) {
    if (!by_packs) return solve_nodes(body, o, begin, end, sums);
    Pack works[2] = {Pack(0.0), Pack(0.0)};
    for_node_packs(
        body, begin, end, [&](const NodeRows& nodes) { solve_free_nodes(body, o, nodes, works); },
        [&](int first, int last) { solve_nodes(body, o, first, last, sums); });
    sums.damped += sum_lanes(works[0]);
    sums.mapping += sum_lanes(works[1]);
  });
}

template <int D>
void remap_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const bool far = body.points.size() > 50000;  // beyond the second-level cache
  for_chunks_and_update(body, o.threads, body.nodes.sums, sums_stride, [&](int c) {
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] == 0) continue;
      const int* rows = &layout.connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
      const double* moments = &body.elements.moments[static_cast<std::size_t>(b) * moment_size<D> * lane_width];
      if (far && b + 2 < layout.blocks) {
        const int* ahead = rows + 2 * (D + 1) * lane_width;
        for (int i = 0; i < (D + 1) * lane_width; ++i) {
          __builtin_prefetch(&body.nodes.motion[static_cast<std::size_t>(ahead[i]) * motion_stride<D>], 0, 3);
          __builtin_prefetch(&body.nodes.sums[static_cast<std::size_t>(ahead[i]) * sums_stride], 1, 3);
        }
        for (int i = 0; i < moment_size<D>; ++i)
          __builtin_prefetch(moments + (2 * moment_size<D> + i) * lane_width, 0, 3);
      }
      remap_block(body, b, o.dt);
    }
  });
  std::vector<std::array<double, 2>> works(static_cast<std::size_t>(layout.chunks));  // external, lost in the mapping
  const bool by_packs = o.moving && body.nodes.load.empty();  // frozen geometry also sums displacements
  for_node_pieces(body, o.threads, [&](int begin, int end, int c) {
    std::array<double, 2> of_piece{};
    Pack by_lane[2] = {Pack(0.0), Pack(0.0)};
    if (by_packs) {
      for_node_packs(
          body, begin, end, [&](const NodeRows& nodes) { remap_free_nodes(body, o, nodes, by_lane); },
          [&](int first, int last) { remap_nodes(body, o, first, last, of_piece); });
    } else {
      remap_nodes(body, o, begin, end, of_piece);
    }
    if (c < 0) return;
    for (std::size_t w = 0; w < 2; ++w)
      works[static_cast<std::size_t>(c)][w] = of_piece[w] + o.dt * sum_lanes(by_lane[w]);
  });
  complete_chunks(body, works);
  for (const auto& work : works) {
    body.work.external += work[0];
    body.work.mapping += work[1];
  }
  body.nodes.motion_step = o.dt;
}

template void solve_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void solve_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);
template void remap_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void remap_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);

// Nodal averages of the volumetric strain increment (2.94): nodes.smoothed = Σ_e value_e V_e / Σ_e V_e over the
// elements at each node that take part.
template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& o) {
  for_blocks_and_update(body, o.threads, body.nodes.average, 2, [&](int b, const int* rows) {
    Pack values[2];
    find_average_parts(body, b, o, values);
    add_average<D>(body.nodes.average, rows, values);
  });
  divide_averages<2, 1>(body, o.threads, body.nodes.average, body.nodes.smoothed.data());
}

template void smooth_increments<2>(Dry, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
