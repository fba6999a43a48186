// SPDX-License-Identifier: MIT
#pragma once
// The textbook one-phase MUSL step, (2.35)–(2.45) with damping (2.89), mass scaling (2.91), mixed integration (2.92)
// and strain smoothing (2.94–2.95), as plain loops over plain structs. The remap (2.41) is a second pass over the
// points; nothing is fused, cached or reordered. The MPM step is compared with it at every point.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "reference/plain_body.hpp"
#include "reference/plain_stress.hpp"

namespace talus::reference {

/// Share of the element volume above which an element at the free surface still counts as full, after (2.92).
inline constexpr double full_share = 0.9;
/// Nodes lighter than this fraction of the lightest point do not move: their mass is round-off.
inline constexpr double massless_fraction = 1e-12;
/// A point outside the mesh by less than this fraction of an altitude is outside by round-off only.
inline constexpr double outside_fraction = 1e-9;

/// Lists the points of every element and decides which elements are full: they hold one material only and either are
/// inside the soil or are filled to more than `full_share`. An element is at the free surface when an element across
/// one of its sides holds no point; the boundary of the mesh is no free surface.
template <int D>
void classify_elements(Body<D>& body, const Settings& settings) {
  body.cells.assign(body.mesh.elements.size(), {});
  for (std::size_t p = 0; p < body.points.size(); ++p) at(body.cells, body.points[p].element).points.push_back(p);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    Cell& cell = at(body.cells, e);
    if (!cell.is_active()) continue;
    double volume = 0;
    bool one_material = true, at_free_surface = false;
    for (std::size_t p : cell.points) {
      volume += body.points[p].volume;
      if (body.points[p].material != body.points[cell.points[0]].material) one_material = false;
    }
    for (int neighbour : at(body.mesh.neighbours, e))
      if (neighbour >= 0 && !at(body.cells, neighbour).is_active()) at_free_surface = !settings.surface_points;
    for (std::size_t p : cell.points)
      if (settings.surface_points && body.points[p].at_surface) at_free_surface = true;
    cell.full = settings.mixed && one_material && (!at_free_surface || volume > full_share * at(body.mesh.volumes, e));
  }
  note_gaps(body, settings);
}

/// Nodal mass (2.35), momentum, gravity and tractions (2.37), and internal force (2.38, 2.92).
template <int D>
void map_points_to_nodes(Body<D>& body) {
  body.nodes.assign(body.mesh.nodes.size(), {});
  for (const Point<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i) {
      Node<D>& node = at(body.nodes, node_of(body.mesh, point.element, i));
      node.mass += n[i] * point.mass;
      node.momentum += n[i] * point.mass * point.v;
    }
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    body.nodes[i].external_force = body.nodes[i].mass * body.gravity;
    if (!body.tractions.empty()) body.nodes[i].external_force += body.tractions[i];
  }
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    const Cell& cell = at(body.cells, e);
    Tensor stress_times_volume = Tensor::Zero();
    if (cell.full)
      stress_times_volume = at(body.mesh.volumes, e) * average_stress(body, cell);
    else
      for (std::size_t p : cell.points) stress_times_volume += body.points[p].volume * body.points[p].sigma;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int i = 0; i <= D; ++i)
      at(body.nodes, node_of(body.mesh, e, i)).internal_force +=
          stress_times_volume.template topLeftCorner<D, D>() * b.row(i).transpose();
  }
}

/// Mass up to which a node does not move [kg].
template <int D>
double massless_limit(const Body<D>& body) {
  double smallest = INFINITY;
  for (const Point<D>& point : body.points) smallest = std::min(smallest, point.mass);
  return massless_fraction * smallest;
}

/// a_i = (f + f_damp)/(β m_i), constrained (2.39, 2.89–2.91). The sign in (2.89) is that of the momentum.
template <int D>
void solve_momentum(Body<D>& body, const Settings& settings) {
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    Node<D>& node = body.nodes[i];
    if (node.mass <= limit) continue;
    // Damping acts on the unbalanced force without the reactions of supports.
    Vector<D> force = body.constraints[i].apply(node.external_force - node.internal_force);
    for (int d = 0; d < D; ++d) {
      const double sign = node.momentum[d] > 0 ? 1 : node.momentum[d] < 0 ? -1 : 0;
      force[d] -= settings.damping * sign * std::abs(force[d]);
    }
    node.acceleration = body.constraints[i].apply(force / (settings.mass_scaling * node.mass));
    if (!settings.fixed_nodes_brake) continue;
    // In its fixed directions the node moves as what holds it: it takes the speed that its points bring there.
    const Vector<D> brought = node.momentum / node.mass;
    node.acceleration -= (brought - body.constraints[i].hold(brought)) / settings.time_step;
  }
}

/// v_p += Δt Σ N_i a_i (2.40).
template <int D>
void accelerate_points(Body<D>& body, const Settings& settings) {
  for (Point<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i)
      point.v += settings.time_step * n[i] * at(body.nodes, node_of(body.mesh, point.element, i)).acceleration;
  }
}

/// v_i from the momentum of the points' new velocities (2.41), constrained.
template <int D>
void remap_momentum(Body<D>& body) {
  std::vector<Vector<D>> momentum(body.nodes.size(), Vector<D>::Zero());
  for (const Point<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i) at(momentum, node_of(body.mesh, point.element, i)) += n[i] * point.mass * point.v;
  }
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    if (body.nodes[i].mass > limit) body.nodes[i].velocity = body.constraints[i].hold(momentum[i] / body.nodes[i].mass);
}

/// x_p += Δt Σ N_i v_i (2.42). relocate_points() then finds the new elements.
template <int D>
void move_points(Body<D>& body, const Settings& settings) {
  for (Point<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i)
      point.x += settings.time_step * n[i] * at(body.nodes, node_of(body.mesh, point.element, i)).velocity;
  }
}

/// Walks to the element that contains the point, each time through the side it lies farthest beyond (in altitudes).
/// Returns false when the point has left the mesh; one that is outside by round-off is put onto the boundary.
template <int D>
bool relocate(const mesh::Mesh<D>& mesh, Point<D>& point) {
  for (int visited = 0; visited <= mesh.element_count(); ++visited) {
    Weights<D> n = shape_functions(mesh, point.element, point.x);
    int next = -1;
    double beyond = 0;
    for (int k = 0; k <= D; ++k) {
      const int neighbour = at(at(mesh.neighbours, point.element), k);
      if (neighbour >= 0 && n[k] < beyond) next = neighbour, beyond = n[k];
    }
    if (next >= 0) {
      point.element = next;
      continue;
    }
    if (n.minCoeff() < -outside_fraction) return false;
    if (n.minCoeff() < 0) {
      n = n.cwiseMax(0.0) / n.cwiseMax(0.0).sum();
      for (int d = 0; d < D; ++d) {
        point.x[d] = 0;
        for (int i = 0; i <= D; ++i) point.x[d] += n[i] * at(at(mesh.nodes, node_of(mesh, point.element, i)), d);
      }
    }
    return true;
  }
  throw std::logic_error("the walk to a point's element goes round in circles");
}

template <int D>
void relocate_points(Body<D>& body) {
  std::vector<Point<D>> inside;
  for (Point<D> point : body.points)
    if (relocate(body.mesh, point))
      inside.push_back(point);
    else
      ++body.left;
  body.points = inside;
}

/// Puts the points' velocities onto those that nodes can have: v_p = Σ N_i u_i, with the u that has the momentum of the
/// points at every node, M u = p. Eight steps of Chebyshev's iteration for lumped⁻¹ M with eigenvalues from 0.1 to 1
/// (Saad 2003, Iterative Methods for Sparse Linear Systems, algorithm 12.1).
template <int D>
void filter_null_modes(Body<D>& body) {
  std::vector<double> mass(body.nodes.size(), 0);
  const auto gather = [&](auto&& velocity) {
    std::vector<Vector<D>> sum(body.nodes.size(), Vector<D>::Zero());
    for (const Point<D>& point : body.points) {
      const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
      for (int i = 0; i <= D; ++i)
        at(sum, node_of(body.mesh, point.element, i)) += n[i] * point.mass * velocity(point, n);
    }
    return sum;
  };
  for (const Point<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i) at(mass, node_of(body.mesh, point.element, i)) += n[i] * point.mass;
  }
  const double limit = massless_limit(body);
  const std::vector<Vector<D>> momentum = gather([](const Point<D>& point, const Weights<D>&) { return point.v; });
  std::vector<Vector<D>> u(body.nodes.size(), Vector<D>::Zero()), d = u;
  for (std::size_t i = 0; i < u.size(); ++i)
    if (mass[i] > limit) u[i] = momentum[i] / mass[i];
  const auto interpolate = [&](const Point<D>& point, const Weights<D>& n) {
    Vector<D> v = Vector<D>::Zero();
    for (int i = 0; i <= D; ++i) v += n[i] * at(u, node_of(body.mesh, point.element, i));
    return v;
  };
  const double theta = 0.55, delta = 0.45;
  double rho = delta / theta;
  for (int k = 0; k < 8; ++k) {
    const std::vector<Vector<D>> product = gather(interpolate);
    const double next = k == 0 ? rho : 1 / (2 * theta / delta - rho);
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!(mass[i] > limit)) continue;
      const Vector<D> residual = (momentum[i] - product[i]) / mass[i];
      d[i] = k == 0 ? Vector<D>(residual / theta) : Vector<D>(next * rho * d[i] + 2 * next / delta * residual);
      u[i] += d[i];
    }
    rho = next;
  }
  for (Point<D>& point : body.points) point.v = interpolate(point, shape_functions(body.mesh, point.element, point.x));
}

/// One step of length Δt.
template <int D>
void step(Body<D>& body, const Settings& settings) {
  classify_elements(body, settings);
  map_points_to_nodes(body);          // (2.35)–(2.38), (2.92)
  solve_momentum(body, settings);     // (2.39), (2.89)
  accelerate_points(body, settings);  // (2.40)
  remap_momentum(body);               // (2.41)
  // The positions wait until the end of the list: the strains belong to the elements the points were in.
  compute_strain_increments(body, settings);  // (2.43), (2.94), (2.95)
  update_points(body, settings);              // (2.44), (2.45)
  if (settings.frozen) return;
  move_points(body, settings);  // (2.42)
  relocate_points(body);
}

// Compiled once, in plain_step.cpp.
extern template void classify_elements(Body<2>&, const Settings&);
extern template void map_points_to_nodes(Body<2>&);
extern template void solve_momentum(Body<2>&, const Settings&);
extern template void compute_strain_increments(Body<2>&, const Settings&);
extern template void update_points(Body<2>&, const Settings&);
extern template std::vector<double> smooth_over_nodes(const Body<2>&, const std::vector<double>&);
extern template void relocate_points(Body<2>&);
extern template void step(Body<2>&, const Settings&);
extern template void classify_elements(Body<3>&, const Settings&);
extern template void map_points_to_nodes(Body<3>&);
extern template void solve_momentum(Body<3>&, const Settings&);
extern template void compute_strain_increments(Body<3>&, const Settings&);
extern template void update_points(Body<3>&, const Settings&);
extern template std::vector<double> smooth_over_nodes(const Body<3>&, const std::vector<double>&);
extern template void relocate_points(Body<3>&);
extern template void step(Body<3>&, const Settings&);

}  // namespace talus::reference
