// SPDX-License-Identifier: MIT
#pragma once
// Water at the free surface: open sides, pressure of ponded water, rain and seepage faces, and the flow through each
// surface (docs/theory/14-two-phase.md).

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/plain_two_phase_momentum.hpp"

namespace talus::reference {

template <int D>
SurfaceCondition<D> surface_condition(const WetBody<D>& body, int node) {
  return body.surface.empty() ? SurfaceCondition<D>{} : body.surface[static_cast<std::size_t>(node)];
}

/// Depth of a node below the level of standing water [m]; negative: the node is dry.
template <int D>
double submergence(const WetBody<D>& body, int node) {
  return surface_condition(body, node).head - at(body.mesh.nodes, node)[1];
}

/// Areas below this fraction of Σ V|∇N| are not a surface: round-off, or the quadrature error of crowded points.
inline constexpr double surface_fraction = 1e-3;

/// Round-off of the sum of open sides that enclose a node, as those of an isolated element do, over their area [-];
/// then the sides that touch the node define the outward direction.
inline constexpr double closed_fraction = 1e-9;

/// Pressure of the outer water on the soil at a node that is loaded by it, under the condition of node `like` [Pa].
template <int D>
double outer_pressure(const WetBody<D>& body, int node, int like) {
  const SurfaceCondition<D> condition = surface_condition(body, like);
  if (condition.kind == SurfaceKind::pressure) return condition.pressure;
  const double unit_weight = body.soils[0].water.density * body.gravity.norm();
  return -unit_weight * std::max(0.0, condition.head - at(body.mesh.nodes, node)[1]);
}

/// Returns whether a node is under outer water, or has a given pressure.
template <int D>
bool has_outer_water(const WetBody<D>& body, int node) {
  const SurfaceKind kind = surface_condition(body, node).kind;
  return kind == SurfaceKind::head || kind == SurfaceKind::pressure;
}

/// Loads an open side whose nodes all have outer water: p̂, linear over the side from its nodes' values, on the water
/// and, in compression, on the mixture. `share` is the part of the side of each node, n S/D. Returns whether it is
/// loaded.
template <int D>
bool load_side(WetBody<D>& body, const std::vector<int>& nodes, const Vector<D>& share) {
  double sum = 0;
  for (int node : nodes) {
    if (!has_outer_water(body, node)) return false;
    sum += outer_pressure(body, node, node);
  }
  for (int node : nodes) {
    const double mean = (sum + outer_pressure(body, node, node)) / (D + 1);
    at(body.nodes, node).water_force += mean * share;
    at(body.nodes, node).force += std::min(0.0, mean) * share;
  }
  return true;
}

/// In an element that is not full the soil, and with it the outer pressure, ends inside: ∮ p̂ N_i n dA over the soil's
/// surface differs from that over the element's by ∫ div(p̂ N_i) dV over what the soil does not fill. p̂ is linear in the
/// element; at the node that is not on the side it follows the condition of the side's last node.
template <int D>
void load_inside(WetBody<D>& body, int e, int opposite, int like) {
  const Gradients<D> b = shape_gradients(body.mesh, e);
  const auto add = [&](double most, auto&& force_of) {
    Weights<D> pressure;
    for (int k = 0; k <= D; ++k) {
      const int node = node_of(body.mesh, e, k);
      pressure[k] = std::min(most, outer_pressure(body, node, k == opposite ? like : node));
    }
    const Vector<D> slope = b.transpose() * pressure;
    const auto integrate = [&](double volume, const Weights<D>& n) {
      for (int i = 0; i <= D; ++i)
        force_of(at(body.nodes, node_of(body.mesh, e, i))) +=
            volume * (n.dot(pressure) * b.row(i).transpose() + n[i] * slope);
    };
    integrate(-at(body.mesh.volumes, e), Weights<D>::Constant(1.0 / (D + 1)));
    for (std::size_t p : at(body.cells, e).points)
      if (soil_of(body, body.points[p]).wet)
        integrate(body.points[p].volume, shape_functions(body.mesh, e, body.points[p].x));
  };
  add(INFINITY, [](WetNode<D>& node) -> Vector<D>& { return node.water_force; });
  add(0, [](WetNode<D>& node) -> Vector<D>& { return node.force; });
}

/// V_p-weighted mean of the pressure over the wet points of an element [Pa].
template <int D>
double mean_pressure(const WetBody<D>& body, const WetCell& cell) {
  double sum = 0, volume = 0;
  for (std::size_t p : cell.points) {
    if (!soil_of(body, body.points[p]).wet) continue;
    sum += body.points[p].volume * body.points[p].pressure;
    volume += body.points[p].volume;
  }
  return sum / volume;
}

/// Returns whether the water is fixed along the normal at all nodes of the side opposite local node `k` of element `e`.
template <int D>
bool is_closed_side(const WetBody<D>& body, int e, int k) {
  const Vector<D> normal = -shape_gradients(body.mesh, e).row(k).transpose().normalized();
  for (int i = 0; i <= D; ++i)
    if (i != k && !is_held(at(body.water_constraints, node_of(body.mesh, e, i)), normal)) return false;
  return true;
}

/// Returns for each element whether it is outside the wet soil: it has no wet soil, and touches none, contains dry
/// soil, has a permeable side of the mesh, or is a neighbour of one that is outside. Other elements without wet soil
/// are gaps.
template <int D>
std::vector<bool> find_outside(const WetBody<D>& body) {
  const int count = body.mesh.element_count();
  std::vector<bool> touched(body.mesh.nodes.size()), outside(static_cast<std::size_t>(count));
  for (int e = 0; e < count; ++e)
    for (int i = 0; i <= D && at(body.cells, e).wet; ++i)
      touched[static_cast<std::size_t>(node_of(body.mesh, e, i))] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (int e = 0; e < count; ++e) {
      if (at(body.cells, e).wet || outside[static_cast<std::size_t>(e)]) continue;
      bool touches = false, reached = at(body.cells, e).is_active();
      for (int k = 0; k <= D; ++k) {
        const int behind = at(at(body.mesh.neighbours, e), k);
        touches = touches || touched[static_cast<std::size_t>(node_of(body.mesh, e, k))];
        reached = reached || (behind < 0 ? !is_closed_side(body, e, k) : outside[static_cast<std::size_t>(behind)]);
      }
      if (!touches || reached) outside[static_cast<std::size_t>(e)] = changed = true;
    }
  }
  return outside;
}

/// Returns whether the side opposite local node `k` of a wet element is permeable.
template <int D>
bool is_open_side(const WetBody<D>& body, const std::vector<bool>& outside, int e, int k) {
  const int behind = at(at(body.mesh.neighbours, e), k);
  return (behind < 0 || outside[static_cast<std::size_t>(behind)]) && !is_closed_side(body, e, k);
}

/// Finds the open sides and loads those under outer water. A side of a wet element is open when the outside is behind
/// it and its nodes do not all hold the water along its normal. Nodes of elements with an open side get their
/// part of the surface, Σ V ∇N: in a partly filled element the surface lies inside, and its inner nodes have a part as
/// well.
template <int D>
void load_free_surface(WetBody<D>& body) {
  std::vector<Vector<D>> facing(body.nodes.size(), Vector<D>::Zero()), touching = facing;
  std::vector<double> size(body.nodes.size(), 0);
  std::vector<int> open_elements(body.nodes.size(), 0);
  const std::vector<bool> outside = find_outside(body);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    bool is_open = false, is_loaded = false;
    for (int k = 0; k <= D; ++k) {
      if (!is_open_side(body, outside, e, k)) continue;
      const Vector<D> share =
          -at(body.mesh.volumes, e) * b.row(k).transpose();  // n S/D: what each node has of the side
      std::vector<int> nodes;
      for (int i = 0; i <= D; ++i)
        if (i != k) nodes.push_back(node_of(body.mesh, e, i));
      is_open = true;
      if (load_side(body, nodes, share) && !is_loaded) {
        is_loaded = true;
        if (!at(body.cells, e).full) load_inside(body, e, k, nodes.back());
      }
      for (int i = 0; i <= D; ++i) {
        at(facing, node_of(body.mesh, e, i)) += share;
        at(size, node_of(body.mesh, e, i)) += share.norm();
        if (i != k) at(touching, node_of(body.mesh, e, i)) += share;
      }
    }
    for (int i = 0; is_open && i <= D; ++i) {
      at(body.nodes, node_of(body.mesh, e, i)).suction += mean_pressure(body, at(body.cells, e));
      ++at(open_elements, node_of(body.mesh, e, i));
    }
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    if (open_elements[i] > 0) node.suction /= open_elements[i];
    if (facing[i].norm() <= closed_fraction * size[i]) facing[i] = touching[i];
    const Vector<D> part = body.water_constraints[i].apply(node.outside);
    if (part.dot(facing[i]) > 0 && part.norm() > surface_fraction * node.outside_scale) node.surface = part;
  }
}

/// Fraction of the potential evaporation from soil under a suction: it decreases over the last tenth before the limit.
inline double evaporation_fraction(double suction, double limit) {
  if (std::isinf(limit)) return 1;
  return std::clamp((limit - suction) / (0.1 * limit), 0.0, 1.0);
}

/// Returns the supply of the condition at a surface node along its outward normal: q̂_n [m/s], negative inwards.
template <int D>
double offered_flux(const SurfaceCondition<D>& condition, const WetNode<D>& node) {
  if (condition.kind == SurfaceKind::flux) return -condition.inflow;
  if (condition.kind != SurfaceKind::rain) return 0;
  return std::min(0.0, condition.rain.dot(node.surface.normalized())) - condition.normal_rain +
         condition.evaporation * evaporation_fraction(node.suction, condition.suction_limit);
}

/// Corrects the relative velocity by an impulse along the normal, opposite on the two phases, if the inflow exceeds the
/// supply or the outflow is below the evaporation; for a given flux always. In fixed directions the supports take the
/// impulse.
template <int D>
void limit_inflow(const WetBody<D>& body, int number, Vector<D>& v, Vector<D>& w) {
  const WetNode<D>& node = at(body.nodes, number);
  const SurfaceCondition<D> condition = surface_condition(body, number);
  if (node.surface.norm() == 0 || node.water_mass <= 0) return;
  if (condition.kind == SurfaceKind::open || condition.kind == SurfaceKind::pressure) return;
  if (condition.kind == SurfaceKind::head && submergence(body, number) > 0) return;
  const Vector<D> normal = node.surface.normalized();
  const double theta = node.water_content();
  const double net = theta * (w - v).dot(normal) - offered_flux(condition, node);
  const Vector<D> solid = at(body.solid_constraints, number).apply(normal) / node.solid_mass;
  const Vector<D> water = at(body.water_constraints, number).apply(normal) / node.water_mass;
  const bool given = condition.kind == SurfaceKind::flux || condition.kind == SurfaceKind::closed;
  const bool leaves = net >= 0 && !given;
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

/// Returns whether the inflow of a surface node with water outside is below the supply.
template <int D>
bool takes_less_than_offered(const WetBody<D>& body, std::size_t number, double time_step) {
  const WetNode<D>& node = body.nodes[number];
  const SurfaceCondition<D> condition = surface_condition(body, static_cast<int>(number));
  if (node.surface.norm() == 0 || node.water_mass <= 0) return false;
  const double offered = condition.kind == SurfaceKind::rain ? offered_flux(condition, node) : 0.0;
  const bool supplies = condition.kind == SurfaceKind::open || condition.kind == SurfaceKind::pressure ||
                        (condition.kind == SurfaceKind::head && submergence(body, static_cast<int>(number)) > 0) ||
                        offered < 0;
  if (!supplies) return false;
  const Vector<D> relative = water_velocity(node) + time_step * node.water_acceleration - solid_velocity(node) -
                             time_step * node.solid_acceleration;
  const double flux = node.water_content() * relative.dot(node.surface.normalized());
  return flux < 0 && (offered == 0 || flux > offered * (1 - 1e-9));
}

/// Accelerations of all nodes: (2.66), (2.67), (2.89)–(2.91), with inflow limited.
template <int D>
void solve_wet_momentum(WetBody<D>& body, const WetSettings& settings) {
  const double limit = massless_limit(body);
  const auto solve = [&](std::size_t i) {
    PhaseForces<D> damping;
    if (settings.damped_force == DampedForce::net) {
      solve_node(body, i, settings, damping);
      limit_predicted_inflow(body, i, settings.time_step);
    }
    damping = find_damping(body.nodes[i], settings);
    solve_node(body, i, settings, damping);
    limit_predicted_inflow(body, i, settings.time_step);
  };
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    if (body.nodes[i].solid_mass <= limit) continue;
    solve(i);
    if (!takes_less_than_offered(body, i, settings.time_step)) continue;
    // Across the surface it conducts as saturated soil.
    WetNode<D>& node = body.nodes[i];
    const Vector<D> solid = node.solid_acceleration, water = node.water_acceleration, n = node.surface.normalized();
    node.drinks = true;
    solve(i);
    node.solid_acceleration = solid + n.dot(node.solid_acceleration - solid) * n;
    node.water_acceleration = water + n.dot(node.water_acceleration - water) * n;
  }
}

/// Adds the flow of this step through a surface node to the budget: `out` [kg] leaves.
template <int D>
WaterBudget pass_surface(const WetBody<D>& body, std::size_t number, double out, double time_step) {
  const WetNode<D>& node = body.nodes[number];
  const SurfaceCondition<D> condition = surface_condition(body, static_cast<int>(number));
  WaterBudget passed{.entered = std::max(0.0, -out), .left = std::max(0.0, out)};
  const double inwards = condition.kind == SurfaceKind::rain ? -offered_flux(condition, node) : 0.0;
  if (inwards <= 0) return passed;
  passed.supplied = body.soils[0].water.density * time_step * node.surface.norm() * inwards;
  passed.runoff = passed.supplied - passed.entered;
  return passed;
}

/// Adds what passes in this step to the budget, with the velocities after the remap.
template <int D>
void count_water(WetBody<D>& body, const WetSettings& settings) {
  body.node_budgets.resize(body.nodes.size());
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const WetNode<D>& node = body.nodes[i];
    if (node.whole_mass <= 0) continue;
    const double density = body.soils[0].water.density;
    const double out = density * node.water_content() * (node.w - node.v).dot(node.outside) * settings.time_step;
    const WaterBudget passed =
        node.surface.norm() == 0 ? WaterBudget{.lost_between = out} : pass_surface(body, i, out, settings.time_step);
    body.budget += passed;
    body.node_budgets[i] += passed;
  }
}

}  // namespace talus::reference
