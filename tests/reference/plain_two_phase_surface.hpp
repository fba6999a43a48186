#pragma once
// Water at the free surface: which sides are open, the pressure of standing water, rain and seepage faces, and the
// count of what passes (docs of the conditions: docs/theory/14-two-phase.md).

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>

#include "reference/plain_two_phase_momentum.hpp"

namespace talus::reference {

template <int D>
SurfaceCondition<D> surface_condition(const WetBody<D>& body, int node) {
  return body.surface.empty() ? SurfaceCondition<D>{} : body.surface[static_cast<std::size_t>(node)];
}

/// Level above a node at which standing water begins [m]; negative: the node is dry.
template <int D>
double submergence(const WetBody<D>& body, int node) {
  return surface_condition(body, node).head - at(body.mesh.nodes, node)[1];
}

/// Shares smaller than this of Σ V|∇N| are no surface: round-off, or the quadrature error of crowded points.
inline constexpr double surface_share = 1e-3;

/// Finds the open sides and loads those under standing water with p̂ = −γ_w (H − y), linear over the side from its
/// nodes' values, on the water and on the mixture. A side of a wet element is open when no wet element is behind it and
/// its nodes do not all hold the water along its normal. Nodes of elements with an open side get their part of the
/// surface, Σ V ∇N: in a partly filled element the surface lies inside, and its inner nodes have a part as well.
template <int D>
void load_free_surface(WetBody<D>& body) {
  std::vector<Vector<D>> facing(body.nodes.size(), Vector<D>::Zero());
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int k = 0; k <= D; ++k) {
      const int neighbour = at(at(body.mesh.neighbours, e), k);
      if (neighbour >= 0 && at(body.cells, neighbour).wet) continue;
      const Vector<D> share =
          -at(body.mesh.volumes, e) * b.row(k).transpose();  // n S/D: what each node has of the side
      bool closed = true, under_head = true;
      double pressure_sum = 0;
      const double unit_weight =
          soil_of(body, body.points[at(body.cells, e).points[0]]).water.density * body.gravity.norm();
      const auto pressure = [&](int node) { return -unit_weight * std::max(0.0, submergence(body, node)); };
      for (int i = 0; i <= D; ++i) {
        if (i == k) continue;
        const int node = node_of(body.mesh, e, i);
        closed = closed && is_held(at(body.water_constraints, node), Vector<D>(share.normalized()));
        under_head = under_head && surface_condition(body, node).kind == SurfaceKind::head;
        pressure_sum += pressure(node);
      }
      if (closed) continue;
      for (int i = 0; i <= D; ++i) {
        const int number = node_of(body.mesh, e, i);
        at(facing, number) += share;
        if (i == k || !under_head) continue;
        const Vector<D> load = (pressure_sum + pressure(number)) / (D + 1) * share;
        at(body.nodes, number).force += load;
        at(body.nodes, number).water_force += load;
      }
    }
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    const Vector<D> part = body.water_constraints[i].apply(node.outside);
    if (part.dot(facing[i]) > 0 && part.norm() > surface_share * node.outside_scale) node.surface = part;
  }
}

/// Rain that is offered to the node, along its outward normal: q̂·n [m/s], not positive.
template <int D>
double offered_rain(const SurfaceCondition<D>& condition, const Vector<D>& normal) {
  if (condition.kind != SurfaceKind::rain) return 0;
  return std::min(0.0, condition.rain.dot(normal)) - condition.normal_rain;
}

/// Where more water would enter than is offered, an impulse along the normal, opposite on the two phases, puts the
/// relative velocity right. What a phase may not do there (held directions) the supports take.
template <int D>
void limit_inflow(const WetBody<D>& body, int number, Vector<D>& v, Vector<D>& w) {
  const WetNode<D>& node = at(body.nodes, number);
  const SurfaceCondition<D> condition = surface_condition(body, number);
  if (condition.kind == SurfaceKind::open || node.surface.norm() == 0 || node.water_mass <= 0) return;
  if (condition.kind == SurfaceKind::head && submergence(body, number) > 0) return;
  const Vector<D> normal = node.surface.normalized();
  const double theta = node.water_content();
  const double net = theta * (w - v).dot(normal) - offered_rain(condition, normal);
  const Vector<D> solid = at(body.solid_constraints, number).apply(normal) / node.solid_mass;
  const Vector<D> water = at(body.water_constraints, number).apply(normal) / node.water_mass;
  const bool leaves = net >= 0 && condition.kind != SurfaceKind::closed;
  if (leaves || water.norm() * node.water_mass < 1e-9) return;
  const double impulse = -net / (theta * (solid + water).dot(normal));
  w += impulse * water;
  v -= impulse * solid;
}

/// The same on the velocities that a node's accelerations predict.
template <int D>
void limit_predicted_inflow(WetBody<D>& body, std::size_t number, double time_step) {
  WetNode<D>& node = body.nodes[number];
  if (node.water_mass <= 0) return;
  const Vector<D> v0 = solid_velocity(node) + time_step * node.solid_acceleration;
  const Vector<D> w0 = water_velocity(node) + time_step * node.water_acceleration;
  Vector<D> v = v0, w = w0;
  limit_inflow(body, static_cast<int>(number), v, w);
  node.solid_acceleration += (v - v0) / time_step;
  node.water_acceleration += (w - w0) / time_step;
}

/// Accelerations of all nodes: (2.66), (2.67), (2.89)–(2.91), with inflow limited.
template <int D>
void solve_wet_momentum(WetBody<D>& body, const WetSettings& settings) {
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    if (body.nodes[i].solid_mass <= limit) continue;
    PhaseForces<D> damping;
    if (settings.damped_force == DampedForce::net) {
      solve_node(body, i, settings, damping);
      limit_predicted_inflow(body, i, settings.time_step);
    }
    damping = find_damping(body.nodes[i], settings);
    solve_node(body, i, settings, damping);
    limit_predicted_inflow(body, i, settings.time_step);
  }
}

/// Adds what passes in this step to the budget, with the velocities after the remap.
template <int D>
void count_water(WetBody<D>& body, const WetSettings& settings) {
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const WetNode<D>& node = body.nodes[i];
    if (node.whole_mass <= 0) continue;
    const double density = body.soils[0].water.density;
    const double out = density * node.water_content() * (node.w - node.v).dot(node.outside) * settings.time_step;
    if (node.surface.norm() == 0) {
      body.budget.lost_between += out;
      continue;
    }
    (out > 0 ? body.budget.left : body.budget.entered) += std::abs(out);
    const double offered =
        -density * settings.time_step * node.surface.norm() *
        offered_rain(surface_condition(body, static_cast<int>(i)), Vector<D>(node.surface.normalized()));
    if (offered <= 0) continue;
    body.budget.supplied += offered;
    body.budget.runoff += offered - std::max(0.0, -out);
  }
}

}  // namespace talus::reference
