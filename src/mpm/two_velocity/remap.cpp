// SPDX-License-Identifier: MIT
// Grid solve of the two-velocity formulation, second mapping of MUSL: nodal velocities of both phases (2.78, 2.79), the
// flux between them, and the water budget.

#include <cmath>

#include "base/rows.hpp"
#include "mpm/state/node_rows.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/solve.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {
namespace {

/// Darcy flux of a node whose water has no inertia: force over resistance, with the constraints of the water and the
/// limits of the surface.
template <int D>
Vec<D> find_still_flux(const NodePass<D>& pass, int i, const double* t, const SurfaceNode<D>& surface) {
  using C = WetColumns<D>;
  const Water<D>& water = pass.body.water;
  const double conductance = t[C::relative] / (t[C::resistance] * t[C::volume]);
  Vec<D> flux;
  for (int d = 0; d < D; ++d) {
    const double outer = water.load.empty() ? 0.0 : water.load[i][d];
    flux[d] = (t[C::water_force + d] + outer + pass.density * t[C::volume] * pass.options.gravity[d]) * conductance;
  }
  if (const int c = water.constraint_of_node[i]; c >= 0)
    flux = remove_fixed<D>(water.constraints[c].fixed, water.constraints[c].fixed_count, flux);
  if (!surface.limits) return flux;
  const double net = dot(flux, surface.normal) - surface.offered;
  if (net < 0 || surface.always) {
    for (int d = 0; d < D; ++d) flux[d] -= net * surface.normal[d];
  }
  return flux;
}

/// Velocity of the grains after the remap and the flux θ(w-v) of a node. Adds the water that passes through the node to
/// `budgets`, or to `lost_between` at nodes that are on no surface.
template <int D>
PhaseVectors<D> remap_node(const NodePass<D>& pass, int i, const double* t, SurfaceBudget* budgets,
                           double& lost_between) {
  using C = WetColumns<D>;
  const Body<D>& body = pass.body;
  const double dt = pass.options.dt;
  PhaseVectors<D> out;  // v, θ(w-v)
  Vec<D>& v = out.solid;
  const double inverse = 1 / t[C::mass];
  for (int d = 0; d < D; ++d) v[d] = t[C::momentum + d] * inverse;
  if (const int c = body.conditions.constraint_of_node[i]; c >= 0)
    v = constrain_remapped(body.conditions, c, v, body.time + dt);
  const double water_mass = t[C::water_mass];
  if (!(water_mass > 0)) return out;
  Vec<D> w;
  const double inverse_water = 1 / water_mass;
  for (int d = 0; d < D; ++d) w[d] = t[C::water_momentum + d] * inverse_water;
  if (const int c = body.water.constraint_of_node[i]; c >= 0)
    w = remove_fixed<D>(body.water.constraints[c].fixed, body.water.constraints[c].fixed_count, w);
  const double theta = water_mass / (pass.density * t[C::volume]);
  SurfaceNode<D> surface;
  if (const Vec<D>& facing = body.water.facing[i]; dot(facing, facing) > 0) {
    surface = find_surface_node(body, i, t + C::outside, t[C::outside_scale], pass.up, body.time);
    limit_inflow(body, i, surface, t[C::mass], water_mass, theta, v, w);
  }
  if (pass.options.exchange_water) pass.body.water.still_flux[i] = find_still_flux(pass, i, t, surface);
  double leaves = 0;
  for (int d = 0; d < D; ++d) {
    out.water[d] = theta * (w[d] - v[d]);
    leaves += out.water[d] * t[C::outside + d];
  }
  leaves *= pass.density * dt;
  if (!surface.condition) {
    lost_between += leaves;
    return out;
  }
  SurfaceBudget& budget = budgets[body.water.surface_of_node[i]];
  (leaves > 0 ? budget.left : budget.entered) += std::abs(leaves);
  const double offered = -pass.density * dt * surface.area * surface.offered;
  if (surface.condition->kind == SurfaceKind::rain && offered > 0) {
    budget.supplied += offered;
    budget.runoff += offered - std::max(0.0, -leaves);
  }
  return out;
}

/// Over Δt: external work of gravity, loads and outside water at a node, and its part of the mapping loss except what
/// solve_momentum() counts (T9.1) [J].
template <int D>
struct NodeWork {
  double external = 0, lost = 0;

  void add(const NodePass<D>& pass, int i, const double* t, const double* a, const PhaseVectors<D>& v) {
    using C = WetColumns<D>;
    const Body<D>& body = pass.body;
    const Water<D>& water = body.water;
    const Vec<D>& g = pass.options.gravity;
    const bool loaded = !body.nodes.load.empty(), pressed = !water.load.empty();
    double work = 0, inside = 0;
    for (int d = 0; d < D; ++d) {
      double darcy = (t[C::mass] + t[C::water_mass]) * g[d], on_water = pass.density * t[C::volume] * g[d];
      if (loaded) darcy += body.nodes.load[i][d];
      if (pressed) {
        darcy += water.darcy_load[i][d];
        on_water += water.load[i][d];
      }
      work += darcy * v.solid[d] + on_water * v.water[d];
      inside += t[C::force + d] * v.solid[d] + t[C::water_force + d] * v.water[d] - a[d] * t[C::momentum + d] -
                a[D + d] * t[C::water_momentum + d];
    }
    external += work;
    lost += work + 0.5 * inside;
  }
};

/// Remap: adds Δt Σ_j M_ij a_j of both phases to the nodal momenta.
template <int D>
void add_momentum_changes(Body<D>& body, const StepOptions<D>& o) {
  using C = WetColumns<D>;
  const Layout<D>& layout = *body.layout;
  Water<D>& water = body.water;
  for_chunks_and_update(body, o.threads, water.sums, wet_sums_stride<D>, [&](int c) {
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] == 0) continue;
      const int* rows = &layout.connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
      const std::size_t first = static_cast<std::size_t>(b) * moment_size<D> * lane_width;
      Pack a[D + 1][D], aw[D + 1][D], m[moment_size<D>], solid[D + 1][D], change[D + 1][D];
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k) {
        Pack both[2 * D];
        load_rows<2 * D, wet_motion_stride<D>>(water.motion.data(), rows + k * lane_width, both);
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) {
          a[k][d] = both[d];
          aw[k][d] = both[D + d];
        }
      }
      TALUS_UNROLL
      for (int q = 0; q < moment_size<D>; ++q)
        m[q] = load<Pack>(&body.elements.moments[first + static_cast<std::size_t>(q) * lane_width]);
      remap_element<D, Pack>(m, a, o.dt, solid);
      TALUS_UNROLL
      for (int q = 0; q < moment_size<D>; ++q)
        m[q] = load<Pack>(&water.moments[first + static_cast<std::size_t>(q) * lane_width]);
      remap_element<D, Pack>(m, aw, o.dt, change);
      // One run of columns from the grains' momentum to the water's; the forces between them are no longer needed.
      constexpr int run = C::water_momentum + D - C::momentum;
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k) {
        Pack out[run];
        TALUS_UNROLL
        for (int i = 0; i < run; ++i) out[i] = Pack(0.0);
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) {
          out[d] = solid[k][d];
          out[C::water_momentum - C::momentum + d] = change[k][d];
        }
        add_rows<run, C::momentum, wet_sums_stride<D>>(water.sums.data(), rows + k * lane_width, out);
      }
    }
  });
}

}  // namespace

template <int D>
void remap_momentum(Wet, Body<D>& body, const StepOptions<D>& o) {
  using C = WetColumns<D>;
  const Layout<D>& layout = *body.layout;
  Water<D>& water = body.water;
  add_momentum_changes(body, o);
  const double cutoff = 1e-12 * body.smallest_mass;
  const NodePass<D> pass(body, o);
  const std::size_t pieces = static_cast<std::size_t>(layout.chunks);
  water.budgets.resize(water.surfaces.size());
  const std::size_t surfaces = water.surfaces.size();
  std::vector<SurfaceBudget> budgets(pieces * surfaces);
  std::vector<double> lost(pieces, 0.0);
  std::vector<NodeWork<D>> works(pieces);
  for_node_pieces(body, o.threads, [&](int begin, int end, int c) {
    double lost_between = 0;
    NodeWork<D> work;
    std::vector<SurfaceBudget> mine(surfaces);
    for (int i = begin; i < end; ++i) {
      const int* node_rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
      const int copies = layout.row_start[i + 1] - layout.row_start[i];
      double t[C::count];
      sum_rows<C::count, wet_sums_stride<D>>(water.sums, node_rows, copies, t);
      PhaseVectors<D> v;
      if (t[C::mass] > cutoff) {
        v = remap_node(pass, i, t, mine.data(), lost_between);
        work.add(pass, i, t, &water.motion[static_cast<std::size_t>(node_rows[0]) * wet_motion_stride<D>], v);
      }
      for (int k = 0; k < copies; ++k) {
        double* sums = &water.sums[static_cast<std::size_t>(node_rows[k]) * wet_sums_stride<D>];
        TALUS_UNROLL
        for (int q = 0; q < wet_sums_stride<D>; ++q) sums[q] = 0;
        double* motion = &water.motion[static_cast<std::size_t>(node_rows[k]) * wet_motion_stride<D>];
        for (int d = 0; d < D; ++d) {
          motion[2 * D + d] = v.solid[d];
          motion[3 * D + d] = v.water[d];
        }
      }
      if (!o.moving) {
        for (int d = 0; d < D; ++d) body.nodes.displacement[i][d] += o.dt * v.solid[d];
      }
    }
    if (c < 0) return;  // counted by another rank
    lost[static_cast<std::size_t>(c)] = lost_between;
    works[static_cast<std::size_t>(c)] = work;
    std::copy(mine.begin(), mine.end(),
              budgets.begin() + static_cast<std::ptrdiff_t>(c) * static_cast<std::ptrdiff_t>(surfaces));
  });
  complete_chunks(body, lost);
  complete_chunks(body, works);
  for (const double mass : lost) water.lost_between += mass;
  for (const NodeWork<D>& work : works) {
    body.work.external += o.dt * work.external;
    body.work.mapping += o.dt * work.lost;
  }
  body.nodes.motion_step = o.dt;
  add_budgets(body, budgets);
}

template void remap_momentum<2>(Wet, Body<2>&, const StepOptions<2>&);
template void remap_momentum<3>(Wet, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
