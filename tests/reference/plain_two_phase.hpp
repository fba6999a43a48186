// SPDX-License-Identifier: MIT
#pragma once
// The textbook two-phase single-point MUSL step of 2.3.4 and 3.2, saturated and unsaturated, as plain loops over plain
// structs, in the order of the source. The two-velocity formulation is compared with it at every point.

#include <Eigen/Dense>
#include <vector>

#include "reference/plain_two_phase_exchange.hpp"
#include "reference/plain_two_phase_strain.hpp"
#include "reference/plain_two_phase_surface.hpp"

namespace talus::reference {

/// Velocities of the points (2.76), (2.77).
template <int D>
void accelerate_wet_points(WetBody<D>& body, const WetSettings& settings) {
  for (WetPoint<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i) {
      const WetNode<D>& node = at(body.nodes, node_of(body.mesh, point.element, i));
      point.v += settings.time_step * n[i] * node.solid_acceleration;
      if (soil_of(body, point).wet) point.w += settings.time_step * n[i] * node.water_acceleration;
    }
  }
}

/// Nodal velocities from the points' new ones (2.78), (2.79), with fixities and the limits of inflow applied once more.
template <int D>
void remap_wet_momentum(WetBody<D>& body) {
  std::vector<Vector<D>> solid(body.nodes.size(), Vector<D>::Zero()), water = solid;
  for (const WetPoint<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i) {
      at(solid, node_of(body.mesh, point.element, i)) += n[i] * point.mass * point.v;
      at(water, node_of(body.mesh, point.element, i)) += n[i] * point.water_mass * point.w;
    }
  }
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    if (node.solid_mass <= limit) continue;
    node.v = body.solid_constraints[i].hold(solid[i] / node.solid_mass);
    if (node.water_mass > 0) node.w = body.water_constraints[i].apply(water[i] / node.water_mass);
    limit_inflow(body, static_cast<int>(i), node.v, node.w);
  }
}

/// Points go with the solid; see move_points() and relocate() of one phase.
template <int D>
void move_wet_points(WetBody<D>& body, const WetSettings& settings) {
  std::vector<WetPoint<D>> inside;
  for (WetPoint<D> point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i)
      point.x += settings.time_step * n[i] * at(body.nodes, node_of(body.mesh, point.element, i)).v;
    if (relocate(body.mesh, point))
      inside.push_back(point);
    else
      ++body.left;
  }
  body.points = inside;
}

/// One step of length Δt.
template <int D>
void step(WetBody<D>& body, const WetSettings& settings) {
  classify_wet_elements(body, settings);
  average_wet_state(body);
  map_wet_points(body);                   // (2.68)–(2.72), (2.75)
  add_wet_forces(body);                   // (2.73), (2.74), (2.92)
  load_free_surface(body);                // (3.11)
  solve_wet_momentum(body, settings);     // (2.66), (2.67), (2.89)–(2.91), rain, seepage faces
  accelerate_wet_points(body, settings);  // (2.76), (2.77)
  remap_wet_momentum(body);               // (2.78), (2.79)
  count_water(body, settings);
  compute_wet_increments(body, settings);   // (2.80), (2.81), (2.94), (2.95)
  smooth_water_increments(body, settings);  // (2.96), (2.97)
  exchange_water(body, settings);           // (T14.9)
  update_wet_points(body, settings);        // (2.82), (3.4), (2.50)
  if (!settings.frozen) move_wet_points(body, settings);
  ++body.steps;
}

// Compiled once, in plain_step.cpp.
extern template void classify_wet_elements(WetBody<2>&, const WetSettings&);
extern template void average_wet_state(WetBody<2>&);
extern template void map_wet_points(WetBody<2>&);
extern template void add_wet_forces(WetBody<2>&);
extern template void load_free_surface(WetBody<2>&);
extern template void solve_wet_momentum(WetBody<2>&, const WetSettings&);
extern template void compute_wet_increments(WetBody<2>&, const WetSettings&);
extern template void smooth_water_increments(WetBody<2>&, const WetSettings&);
extern template void update_wet_points(WetBody<2>&, const WetSettings&);
extern template void exchange_water(WetBody<2>&, const WetSettings&);
extern template void move_wet_points(WetBody<2>&, const WetSettings&);
extern template void step(WetBody<2>&, const WetSettings&);
extern template void classify_wet_elements(WetBody<3>&, const WetSettings&);
extern template void average_wet_state(WetBody<3>&);
extern template void map_wet_points(WetBody<3>&);
extern template void add_wet_forces(WetBody<3>&);
extern template void load_free_surface(WetBody<3>&);
extern template void solve_wet_momentum(WetBody<3>&, const WetSettings&);
extern template void compute_wet_increments(WetBody<3>&, const WetSettings&);
extern template void smooth_water_increments(WetBody<3>&, const WetSettings&);
extern template void update_wet_points(WetBody<3>&, const WetSettings&);
extern template void exchange_water(WetBody<3>&, const WetSettings&);
extern template void move_wet_points(WetBody<3>&, const WetSettings&);
extern template void step(WetBody<3>&, const WetSettings&);

}  // namespace talus::reference
