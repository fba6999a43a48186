// SPDX-License-Identifier: MIT
// Grid solve of the two-velocity formulation: accelerations of both phases at the nodes (T14.5, T14.6), with drag,
// damping, constraints and surface conditions.

#include <cmath>

#include "base/rows.hpp"
#include "mpm/state/node_rows.hpp"
#include "mpm/two_velocity/free_nodes.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/solve.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {
namespace {

template <int D>
HeldAxes<D> make_held_axes(const Constraint<D>* solid, const WaterConstraint<D>* water) {
  HeldAxes<D> h;
  int found = 0;
  const auto add = [&](Vec<D> n) {
    for (int k = 0; k < found; ++k) {
      const double along = dot(h.axis[k], n);
      for (int d = 0; d < D; ++d) n[d] -= along * h.axis[k][d];
    }
    const double length = norm(n);
    if (found == D || length < 1e-9) return;
    for (double& c : n) c /= length;
    h.axis[found++] = n;
  };
  for (int k = 0; solid && k < solid->fixed_count; ++k) add(solid->fixed[k]);
  for (int k = 0; water && k < water->fixed_count; ++k) add(water->fixed[k]);
  for (int d = 0; d < D; ++d) {
    Vec<D> unit{};
    unit[d] = 1;
    add(unit);
  }
  for (int k = 0; k < D; ++k) {
    h.solid[k] = solid && norm(remove_fixed<D>(solid->fixed, solid->fixed_count, h.axis[k])) < 1e-9;
    h.water[k] = water && norm(remove_fixed<D>(water->fixed, water->fixed_count, h.axis[k])) < 1e-9;
  }
  return h;
}

/// Masses, velocities and forces in the equations of one node (T14.3, T14.4), from its sums.
template <int D>
struct TwoVelocityNode {
  using C = WetColumns<D>;
  double solid_mass, water_mass, whole_mass, content;
  PhaseVectors<D> now;    ///< nodal velocities before the solve, p/m [m/s]
  PhaseForces<D> forces;  ///< without drag [N]
  Vec<D> darcy{};         ///< unbalanced force of the mixture [N]
  Vec<D> external{};      ///< gravity and loads on the mixture [N]
  PhasePair pair;

  TALUS_KERNEL TwoVelocityNode(const NodePass<D>& pass, int i, const double* t)
      : solid_mass(t[C::mass]),
        water_mass(t[C::water_mass]),
        whole_mass(pass.density * t[C::volume]),
        content(water_mass > 0 ? water_mass / whole_mass : 0.0),
        pair(solid_mass, water_mass > 0 ? whole_mass : 0.0, content,
             water_mass > 0 ? t[C::resistance] * t[C::volume] / t[C::relative] : 0.0, pass.options.mass_scaling,
             pass.options.dt, pass.options.implicit_drag) {
    const Body<D>& body = pass.body;
    const Water<D>& water = body.water;
    const double inverse_solid = 1 / solid_mass, inverse_water = water_mass > 0 ? 1 / water_mass : 0.0;
    for (int d = 0; d < D; ++d) {
      now.solid[d] = t[C::momentum + d] * inverse_solid;
      now.water[d] = t[C::water_momentum + d] * inverse_water;
      external[d] = (solid_mass + water_mass) * pass.options.gravity[d];
      forces.water[d] = t[C::water_force + d] + whole_mass * pass.options.gravity[d];
    }
    if (!body.nodes.load.empty()) {
      for (int d = 0; d < D; ++d) external[d] += body.nodes.load[i][d];
    }
    if (!water.load.empty()) {
      for (int d = 0; d < D; ++d) {
        external[d] += water.darcy_load[i][d];
        forces.water[d] += water.load[i][d];
      }
    }
    for (int d = 0; d < D; ++d) {
      darcy[d] = t[C::force + d] + external[d];
      forces.solid[d] = darcy[d] - content * forces.water[d];
    }
  }
};

template <int D>
TALUS_KERNEL PhaseForces<D> add(PhaseForces<D> f, const PhaseForces<D>& more) {
  for (int d = 0; d < D; ++d) {
    f.solid[d] += more.solid[d];
    f.water[d] += more.water[d];
  }
  return f;
}

/// Force that net damping acts on: the inertia, which is net of drag and of reactions (T14.10).
template <int D>
TALUS_KERNEL PhaseForces<D> find_inertia(const PhasePair& pair, const PhaseVectors<D>& a) {
  PhaseForces<D> f;
  for (int d = 0; d < D; ++d) {
    f.solid[d] = pair.solid * a.solid[d];
    f.water[d] = pair.water * a.water[d];
  }
  return f;
}

template <int D>
TALUS_KERNEL PhaseForces<D> find_phase_damping(const StepOptions<D>& o, const PhaseForces<D>& unbalanced,
                                               const PhaseVectors<D>& now) {
  return {find_damping<D>(unbalanced.solid, now.solid, o.damping),
          find_damping<D>(unbalanced.water, now.water, o.water_damping)};
}

/// Accelerations of a node whose grains are at a frictional wall or have a moving support.
template <int D>
void solve_at_wall(Body<D>& body, const StepOptions<D>& o, int c, const TwoVelocityNode<D>& node,
                   const HeldAxes<D>& held, const PhaseForces<D>& forces, PhaseVectors<D>& a) {
  const Constraint<D>& k = body.conditions.constraints[c];
  Vec<D> wanted;
  for (int d = 0; d < D; ++d) wanted[d] = node.now.solid[d] + o.dt * a.solid[d];
  body.conditions.pressed[c] = dot(wanted, k.wall_normal) > 0;
  const Vec<D> allowed = constrain_velocity(body.conditions, k, wanted, body.time + o.dt);
  for (int d = 0; d < D; ++d) a.solid[d] = (allowed[d] - node.now.solid[d]) / o.dt;
  a.water = solve_water_alone<D>(node.pair, held, forces.water, node.now, a.solid, o.dt);
}

/// Accelerations of a node under its forces and `damping`, with supports, walls and surface conditions.
template <int D>
PhaseVectors<D> solve_node(const NodePass<D>& pass, int i, const TwoVelocityNode<D>& node, const HeldAxes<D>* held,
                           const SurfaceNode<D>& surface, const PhaseForces<D>& damping) {
  Body<D>& body = pass.body;
  const double dt = pass.options.dt;
  const PhaseForces<D> f = add(node.forces, damping);
  PhaseVectors<D> a =
      held ? solve_held_phases<D>(node.pair, *held, f, node.now, dt) : solve_free_phases<D>(node.pair, f, node.now);
  const int c = body.conditions.constraint_of_node[i];
  if (held && c >= 0 && (body.conditions.constraints[c].has_wall || body.conditions.constraints[c].factor >= 0))
    solve_at_wall(body, pass.options, c, node, *held, f, a);
  if (!surface.limits || node.water_mass <= 0) return a;
  Vec<D> v0, w0;
  for (int d = 0; d < D; ++d) {
    v0[d] = node.now.solid[d] + dt * a.solid[d];
    w0[d] = node.now.water[d] + dt * a.water[d];
  }
  Vec<D> v = v0, w = w0;
  if (limit_inflow(body, i, surface, node.solid_mass, node.water_mass, node.content, v, w)) {
    for (int d = 0; d < D; ++d) {
      a.solid[d] += (v[d] - v0[d]) / dt;
      a.water[d] += (w[d] - w0[d]) / dt;
    }
  }
  return a;
}

template <int D>
void monitor_node(const Body<D>& body, int i, const TwoVelocityNode<D>& node, PieceSums& sums) {
  Vec<D> f = node.darcy, f_ext = node.external, v = node.now.solid;
  if (const int c = body.conditions.constraint_of_node[i]; c >= 0) {
    const Constraint<D>& k = body.conditions.constraints[c];
    f = unsupported_part(k, k.has_wall && body.conditions.pressed[c], f);
    f_ext = free_part(k, f_ext);
    v = free_part(k, v);
  }
  sums.out_of_balance2 += dot(f, f);
  sums.external2 += dot(f_ext, f_ext);
  // Steady seepage counts as rest: only the soil's speed is judged.
  const double water2 = dot(node.now.water, node.now.water), speed2 = dot(v, v) + (std::isfinite(water2) ? 0 : water2);
  sums.kinetic += 0.5 * (node.solid_mass * dot(v, v) + node.water_mass * water2);
  sums.note_speed(speed2, i);
}

/// Returns whether a surface with outside water takes in less water than is available. Such a surface is wet and
/// conducts like saturated soil, however dry the element behind it is on average.
template <int D>
bool drinks(const SurfaceNode<D>& surface, const TwoVelocityNode<D>& node, const PhaseVectors<D>& a, double dt) {
  if (!surface.supplies || !(node.water_mass > 0)) return false;
  double flux = 0;
  for (int d = 0; d < D; ++d) {
    const double relative = node.now.water[d] + dt * a.water[d] - node.now.solid[d] - dt * a.solid[d];
    flux += node.content * relative * surface.normal[d];
  }
  return flux < 0 && (surface.offered == 0 || flux > surface.offered * (1 - 1e-9));
}

/// Accelerations of a node with supports, at a wall or on the surface. Writes the damping forces.
template <int D>
PhaseVectors<D> solve_bound_node(const NodePass<D>& pass, int i, const double* t, const TwoVelocityNode<D>& node,
                                 PhaseForces<D>& damping) {
  using C = WetColumns<D>;
  const Body<D>& body = pass.body;
  const StepOptions<D>& o = pass.options;
  const int axes = body.water.axes_of_node[i];
  const HeldAxes<D>* held = axes >= 0 ? &body.water.axes[axes] : nullptr;
  const SurfaceNode<D> surface = find_surface_node(body, i, t + C::outside, t[C::outside_scale], pass.up, body.time);
  const auto solve = [&](const TwoVelocityNode<D>& n) {
    if (o.damping > 0 || o.water_damping > 0) {
      const PhaseForces<D> unbalanced =
          o.net_damping ? find_inertia(n.pair, solve_node(pass, i, n, held, surface, {})) : n.forces;
      damping = find_phase_damping(o, unbalanced, n.now);
    }
    return solve_node(pass, i, n, held, surface, damping);
  };
  PhaseVectors<D> a = solve(node);
  if (!drinks(surface, node, a, o.dt)) return a;
  TwoVelocityNode<D> wetted = node;
  wetted.pair = PhasePair(node.solid_mass, node.whole_mass, node.content, t[C::resistance], o.mass_scaling, o.dt,
                          o.implicit_drag);
  // Saturated conductivity applies across the surface only; along it, the mean relative conductivity of the soil does.
  const PhaseVectors<D> b = solve(wetted);
  double solid = 0, water = 0;
  for (int d = 0; d < D; ++d) {
    solid += (b.solid[d] - a.solid[d]) * surface.normal[d];
    water += (b.water[d] - a.water[d]) * surface.normal[d];
  }
  for (int d = 0; d < D; ++d) {
    a.solid[d] += solid * surface.normal[d];
    a.water[d] += water * surface.normal[d];
  }
  return a;
}

/// Adds the work of damping, of drag, and of walls and supports (friction along the way, and the motion that they
/// stop). The other terms of the mapping loss are counted in the remap (T9.1).
template <int D>
void count_node_work(const StepOptions<D>& o, const TwoVelocityNode<D>& node, const PhaseForces<D>& damping,
                     const PhaseVectors<D>& a, bool held, PieceSums& sums) {
  double damped = 0, drag = 0, walls = 0;
  const PhasePair& pair = node.pair;
  const double implicit = o.implicit_drag ? o.dt : 0.0;
  for (int d = 0; d < D; ++d) {
    const double v = node.now.solid[d], w = node.now.water[d];
    const double dv = o.dt * a.solid[d], dw = o.dt * a.water[d];
    const double relative = w - v + implicit * (a.water[d] - a.solid[d]), pull = pair.drag * relative;
    damped -= (damping.solid[d] * (v + 0.5 * dv) + node.content * damping.water[d] * (w + 0.5 * dw)) * o.dt;
    drag += node.content * pull * relative * o.dt;
    if (!held) continue;
    const double on_solid = pair.solid * a.solid[d] - node.forces.solid[d] - damping.solid[d] - node.content * pull;
    const double on_water = pair.water * a.water[d] - node.forces.water[d] - damping.water[d] + pull;
    walls -= (on_solid * (v + 0.5 * dv) + node.content * on_water * (w + 0.5 * dw)) * o.dt;
  }
  sums.damped += damped;
  sums.drag += drag;
  sums.walls += walls;
  sums.mapping -= damped + drag + walls;
}

/// Solves the nodes [begin, end) one by one; handles every kind of node.
template <int D>
void solve_single_nodes(const NodePass<D>& pass, int begin, int end, PieceSums& sums) {
  using C = WetColumns<D>;
  Body<D>& body = pass.body;
  const StepOptions<D>& o = pass.options;
  const Layout<D>& layout = *body.layout;
  const double cutoff = 1e-12 * body.smallest_mass;
  const bool damps = o.damping > 0 || o.water_damping > 0;
  const double last_dt = body.nodes.motion_step;
  for (int i = begin; i < end; ++i) {
    const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
    const int copies = layout.row_start[i + 1] - layout.row_start[i];
    double t[C::count];
    sum_rows<C::count, wet_sums_stride<D>>(body.water.sums, rows, copies, t);
    PhaseVectors<D> a;
    if (t[C::mass] > cutoff) {
      const TwoVelocityNode<D> node(pass, i, t);
      const Vec<D>& facing = body.water.facing[i];
      PhaseForces<D> damping;
      const bool held = body.water.axes_of_node[i] >= 0;
      if (!held && dot(facing, facing) == 0) {
        a = solve_free_phases<D>(node.pair, node.forces, node.now);
        if (damps) {
          damping = find_phase_damping(o, o.net_damping ? find_inertia(node.pair, a) : node.forces, node.now);
          a = solve_free_phases<D>(node.pair, add(node.forces, damping), node.now);
        }
      } else {
        a = solve_bound_node(pass, i, t, node, damping);
      }
      const double* last = &body.water.motion[static_cast<std::size_t>(rows[0]) * wet_motion_stride<D>];
      double lost = 0;
      for (int d = 0; d < D; ++d)
        lost += last_dt * (t[C::force + d] * last[2 * D + d] + t[C::water_force + d] * last[3 * D + d]) -
                o.dt * (a.solid[d] * t[C::momentum + d] + a.water[d] * t[C::water_momentum + d]);
      sums.mapping += 0.5 * lost;
      count_node_work(o, node, damping, a, held, sums);
      if (o.monitor) monitor_node(body, i, node, sums);
    }
    for (int k = 0; k < copies; ++k) {
      double* row = &body.water.motion[static_cast<std::size_t>(rows[k]) * wet_motion_stride<D>];
      for (int d = 0; d < D; ++d) {
        row[d] = a.solid[d];
        row[D + d] = a.water[d];
      }
    }
  }
}

template <int D>
void solve_nodes(const NodePass<D>& pass, int begin, int end, PieceSums& sums) {
  const Body<D>& body = pass.body;
  if (pass.options.monitor || !body.nodes.load.empty() || !body.water.load.empty()) {
    solve_single_nodes(pass, begin, end, sums);
    return;
  }
  PackWork work;
  int i = begin;
  for (; i + lane_width <= end; i += lane_width) {
    const NodePack<D> nodes(body, i);
    if (nodes.has_free()) solve_free_nodes(pass.body, pass.options, pass.density, nodes, work);
    for (unsigned left = nodes.special; left != 0; left &= left - 1) {
      const int special = i + __builtin_ctz(left);
      solve_single_nodes(pass, special, special + 1, sums);
    }
  }
  solve_single_nodes(pass, i, end, sums);
  work.add_to(sums);
}

}  // namespace

template <int D>
void find_held_axes(Body<D>& body) {
  Water<D>& water = body.water;
  const std::size_t nodes = body.mesh().nodes.size();
  water.axes.clear();
  water.axes_of_node.assign(nodes, -1);
  for (std::size_t i = 0; i < nodes; ++i) {
    const int c = body.conditions.constraint_of_node[i], cw = water.constraint_of_node[i];
    if (c < 0 && cw < 0) continue;
    water.axes_of_node[i] = static_cast<int>(water.axes.size());
    water.axes.push_back(make_held_axes<D>(c >= 0 ? &body.conditions.constraints[c] : nullptr,
                                           cw >= 0 ? &water.constraints[cw] : nullptr));
  }
}

template <int D>
void solve_momentum(Wet, Body<D>& body, const StepOptions<D>& o) {
  const NodePass<D> pass(body, o);
  solve_pieces(body, o.threads, body.water.sums, wet_sums_stride<D>, o.monitor,
               [&](int begin, int end, PieceSums& sums) { solve_nodes(pass, begin, end, sums); });
}

template void find_held_axes<2>(Body<2>&);
template void find_held_axes<3>(Body<3>&);
template void solve_momentum<2>(Wet, Body<2>&, const StepOptions<2>&);
template void solve_momentum<3>(Wet, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
