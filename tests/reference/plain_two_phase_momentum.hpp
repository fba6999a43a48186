// SPDX-License-Identifier: MIT
#pragma once
// Nodal accelerations of both phases: implicit or explicit drag, damping, fixed nodes (2.66, 2.67, 2.89–2.91).

#include <Eigen/Dense>
#include <cmath>

#include "reference/plain_two_phase_forces.hpp"

namespace talus::reference {

/// Quantities of one node in one direction. `water_force` is that of (2.67), per unit of n S; `solid_force` is the
/// mixture's force minus n S times it. Both contain no drag.
struct NodeDirection {
  double solid_mass, water_mass;  ///< M_s and M_w (of the whole volume), times β [kg]
  double content;                 ///< θ = n S
  double drag;                    ///< [kg/s]
  double v, w;                    ///< at the start of the step [m/s]
  double solid_force, water_force;
  bool solid_fixed, water_fixed;
  double drive = 0;  ///< of what holds the solid [m/s]
};

struct Accelerations {
  double solid = 0, water = 0;
};

/// Solves, with w' = w + Δt a_w and v' = v + Δt a_s (implicit) or w' = w and v' = v (explicit),
///     M_w a_w = F_w − D(w' − v'),   M_s a_s = F_s + θ D(w' − v').
/// A fixed phase loses the velocity that its points bring, a = (drive − v)/Δt with the solid's drive; it acts on the
/// other phase through the drag.
inline Accelerations solve_direction(const NodeDirection& n, double time_step, Drag drag) {
  const double g = drag == Drag::implicit_at_nodes ? n.drag * time_step : 0.0;
  const double water = n.water_force - n.drag * (n.w - n.v);
  const double solid = n.solid_force + n.content * n.drag * (n.w - n.v);
  Accelerations a;
  if (n.solid_fixed) a.solid = (n.drive - n.v) / time_step;
  if (n.water_fixed) a.water = -n.w / time_step;
  if (n.water_mass <= 0) {
    a.water = 0;
    if (!n.solid_fixed) a.solid = n.solid_force / n.solid_mass;
  } else if (!n.solid_fixed && !n.water_fixed) {
    const double solid_side = n.solid_mass + n.content * g, water_side = n.water_mass + g;
    const double determinant = n.solid_mass * n.water_mass + g * (n.solid_mass + n.content * n.water_mass);
    a.water = (solid_side * water + g * solid) / determinant;
    a.solid = (water_side * solid + n.content * g * water) / determinant;
  } else if (!n.water_fixed) {
    a.water = (water + g * a.solid) / (n.water_mass + g);
  } else if (!n.solid_fixed) {
    a.solid = (solid + n.content * g * a.water) / (n.solid_mass + n.content * g);
  }
  return a;
}

/// −α sign(velocity)|unbalanced| in every component (2.89).
template <int D>
Vector<D> damp(const Vector<D>& unbalanced, const Vector<D>& velocity, double alpha) {
  Vector<D> force = Vector<D>::Zero();
  for (int d = 0; d < D; ++d) {
    const double sign = velocity[d] > 0 ? 1 : velocity[d] < 0 ? -1 : 0;
    force[d] = -alpha * sign * std::abs(unbalanced[d]);
  }
  return force;
}

/// Orthonormal directions in which each phase is either free or fixed: normals of inclined walls, then the axes.
template <int D>
Eigen::Matrix<double, D, D> constraint_axes(const Constraint<D>& solid, const Constraint<D>& water) {
  Eigen::Matrix<double, D, D> axes = Eigen::Matrix<double, D, D>::Identity();
  int found = 0;
  const auto add = [&](Vector<D> direction) {
    for (int k = 0; k < found; ++k) direction -= axes.col(k).dot(direction) * axes.col(k);
    if (found < D && direction.norm() > 1e-9) axes.col(found++) = direction.normalized();
  };
  add(solid.normal);
  add(water.normal);
  for (int d = 0; d < D; ++d) add(Vector<D>::Unit(d));
  return axes;
}

/// Returns whether the constraint forbids all motion along the unit vector.
template <int D>
bool is_held(const Constraint<D>& constraint, const Vector<D>& direction) {
  return constraint.apply(direction).norm() < 1e-9;
}

template <int D>
double massless_limit(const WetBody<D>& body) {
  double smallest = INFINITY;
  for (const WetPoint<D>& point : body.points) smallest = std::min(smallest, point.mass);
  return massless_fraction * smallest;
}

/// Forces on the solid and, per unit of n S, on the water, without drag.
template <int D>
struct PhaseForces {
  Vector<D> solid = Vector<D>::Zero(), water = Vector<D>::Zero();
};

template <int D>
Vector<D> solid_velocity(const WetNode<D>& node) {
  return node.solid_momentum / node.solid_mass;
}
template <int D>
Vector<D> water_velocity(const WetNode<D>& node) {
  if (node.water_mass <= 0) return Vector<D>::Zero();
  return node.water_momentum / node.water_mass;
}

/// Damping forces of a node. DampedForce::net needs the accelerations of a solution without damping.
template <int D>
PhaseForces<D> find_damping(const WetNode<D>& node, const WetSettings& settings) {
  Vector<D> water = node.water_force, solid = node.force - node.water_content() * node.water_force;
  if (settings.damped_force == DampedForce::net) {
    water = settings.mass_scaling * node.whole_mass * node.water_acceleration;
    solid = settings.mass_scaling * node.solid_mass * node.solid_acceleration;
  }
  return {damp<D>(solid, solid_velocity(node), settings.damping),
          damp<D>(water, water_velocity(node), settings.water_damping)};
}

/// Accelerations of a node under its forces and `extra` ones, with the constraints of each phase.
template <int D>
void solve_node(WetBody<D>& body, std::size_t number, const WetSettings& settings, const PhaseForces<D>& extra) {
  WetNode<D>& node = body.nodes[number];
  const double theta = node.water_content();
  const Vector<D> v = solid_velocity(node), w = water_velocity(node);
  const Vector<D> water_force = node.water_force + extra.water;
  const Vector<D> solid_force = node.force - theta * node.water_force + extra.solid;
  const auto axes = constraint_axes(body.solid_constraints[number], body.water_constraints[number]);
  node.solid_acceleration.setZero();
  node.water_acceleration.setZero();
  for (int k = 0; k < D; ++k) {
    const Vector<D> axis = axes.col(k);
    const Accelerations a = solve_direction({.solid_mass = settings.mass_scaling * node.solid_mass,
                                             .water_mass = settings.mass_scaling * node.whole_mass,
                                             .content = theta,
                                             .drag = node.drag(),
                                             .v = v.dot(axis),
                                             .w = w.dot(axis),
                                             .solid_force = solid_force.dot(axis),
                                             .water_force = water_force.dot(axis),
                                             .solid_fixed = is_held(body.solid_constraints[number], axis),
                                             .water_fixed = is_held(body.water_constraints[number], axis),
                                             .drive = body.solid_constraints[number].drive.dot(axis)},
                                            settings.time_step, settings.drag);
    node.solid_acceleration += a.solid * axis;
    node.water_acceleration += a.water * axis;
  }
}

}  // namespace talus::reference
