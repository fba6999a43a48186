// SPDX-License-Identifier: MIT
#pragma once
// The plain step of the mixture with continuous pore pressures, semi-implicit: everything but the pressure is explicit,
// and the pressure of the end of the step is that at which pores and water agree (docs/theory/22-mixture.md). The step
// is bounded by waves in the drained soil alone.

#include <vector>

#include "reference/plain_mixture_pressure.hpp"
#include "reference/plain_two_phase.hpp"

namespace talus::reference {

/// v* and the acceleration that leads to it: the forces of the start of the step, damped.
template <int D>
struct Prediction {
  std::vector<Vector<D>> velocity, acceleration, start;  ///< by node
};

template <int D>
double mixture_mass(const WetNode<D>& node) {
  return node.solid_mass + node.water_mass;
}

template <int D>
Prediction<D> predict_motion(const MixtureBody<D>& body, const MixtureSettings& settings) {
  Prediction<D> p;
  const std::vector<Vector<D>> zero(body.nodes.size(), Vector<D>::Zero());
  p.velocity = p.acceleration = p.start = zero;
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const WetNode<D>& node = body.nodes[i];
    if (node.solid_mass <= limit) continue;
    const double mass = mixture_mass(node);
    p.start[i] = (node.solid_momentum + node.water_momentum) / mass;
    const Vector<D> force = node.force + damp<D>(node.force, p.start[i], settings.damping);
    p.velocity[i] =
        body.solid_constraints[i].apply(p.start[i] + settings.time_step / (settings.mass_scaling * mass) * force);
    p.acceleration[i] = (p.velocity[i] - p.start[i]) / settings.time_step;
  }
  return p;
}

/// The velocity under the pressures of the end of the step, to the points and back (2.76–2.79).
template <int D>
void move_mixture(MixtureBody<D>& body, const MixtureSettings& settings, const Prediction<D>& predicted,
                  const std::vector<ElementFlow>& flow) {
  std::vector<double> change(body.nodes.size(), 0);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = body.water[i].change;
  const std::vector<Vector<D>> force = find_pressure_force(body, flow, change);
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    if (node.solid_mass <= limit) continue;
    const Vector<D> whole = node.force + force[i];
    const Vector<D> velocity = body.solid_constraints[i].apply(
        predicted.start[i] + settings.time_step / (settings.mass_scaling * mixture_mass(node)) *
                                 (whole + damp<D>(whole, predicted.start[i], settings.damping)));
    node.solid_acceleration = (velocity - predicted.start[i]) / settings.time_step;
  }
  std::vector<Vector<D>> momentum(body.nodes.size(), Vector<D>::Zero());
  for (WetPoint<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i)
      point.v += settings.time_step * n[i] * at(body.nodes, node_of(body.mesh, point.element, i)).solid_acceleration;
    for (int i = 0; i <= D; ++i)
      at(momentum, node_of(body.mesh, point.element, i)) += n[i] * (point.mass + point.water_mass) * point.v;
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    if (node.solid_mass <= limit) continue;
    node.v = node.w = body.solid_constraints[i].apply(momentum[i] / mixture_mass(node));
  }
}

/// Once, what leaves a node is spread over its elements and so over their other nodes; twice, a second round gives back
/// most of what went astray.
inline constexpr int water_rounds = 2;

/// What left the nodes is taken from the elements, in proportion to their pores (T22.5), and the budget is kept.
/// Elements lose as much as the nodes do: no water is lost.
template <int D>
void move_water(MixtureBody<D>& body, const MixtureSettings& settings) {
  for (const WetCell& cell : body.cells) {
    if (!cell.full || !cell.wet) continue;
    const ElementWater water = find_element_water(body, cell);
    for (std::size_t p : cell.points) {
      WetPoint<D>& point = body.points[p];
      point.water_mass = soil_of(body, point).water.density * water.water * pore_volume(body, point) / water.pores;
    }
  }
  std::vector<double> rest(body.water.size(), 0);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = body.water[i].out;
  for (int round = 0; round < water_rounds; ++round) {
    std::vector<double> given(body.water.size(), 0);
    for (int e = 0; e < body.mesh.element_count(); ++e) {
      const WetCell& cell = at(body.cells, e);
      if (!cell.wet) continue;
      double share = 0;  // of every pore [m³/m³]
      for (int i = 0; i <= D; ++i) {
        const int node = node_of(body.mesh, e, i);
        share += at(rest, node) / at(body.water, node).pores / (D + 1);
      }
      for (std::size_t p : cell.points) {
        WetPoint<D>& point = body.points[p];
        const Soil& soil = soil_of(body, point);
        if (!soil.wet) continue;
        point.water_mass -= soil.water.density * pore_volume(body, point) * share;
        for (int i = 0; i <= D; ++i) at(given, node_of(body.mesh, e, i)) += pore_volume(body, point) * share / (D + 1);
      }
    }
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= given[i];
  }
  const double density = body.soils[0].water.density;
  body.node_budgets.resize(body.water.size());
  for (std::size_t i = 0; i < body.water.size(); ++i) {
    WaterNode& node = body.water[i];
    if (node.pores <= 0) continue;
    body.pressure[i] += node.change;
    WaterBudget passed{.entered = density * std::max(0.0, -node.passed), .left = density * std::max(0.0, node.passed)};
    const bool is_rain = surface_condition(body, static_cast<int>(i)).kind == SurfaceKind::rain;
    const double offered = density * settings.time_step * node.offered;
    if (is_rain && offered > 0) passed.supplied = offered, passed.runoff = offered - passed.entered;
    body.budget += passed;
    body.node_budgets[i] += passed;
  }
}

/// Volumes, effective stresses and pressures of the points.
template <int D>
void update_mixture_points(MixtureBody<D>& body, const MixtureSettings& settings) {
  body.plastic_dilation.assign(body.cells.size(), 0);
  for (std::size_t e = 0; e < body.cells.size(); ++e) {
    const WetCell& cell = body.cells[e];
    // The pores grow with the strain that the pressures work on, which is not smoothed.
    const double growth = cell.stretch * settings.time_step * cell.gradient.trace();
    const Tensor r = settings.objective ? rotation_increment(cell.gradient, settings.time_step) : Tensor::Identity();
    double dilation = 0, volume = 0;
    const double pressure = cell.wet ? mean_over_nodes(body.mesh, static_cast<int>(e), body.pressure) : 0.0;
    for (std::size_t p : cell.points) {
      WetPoint<D>& point = body.points[p];
      const Soil& soil = soil_of(body, point);
      if (settings.frozen && soil.wet)  // frozen pores hold what they would press out
        point.water_mass -= soil.water.density * point.volume * soil.water.saturation(point.pressure) * growth;
      const StressUpdate update =
          update_moving_stress(soil.skeleton, r * point.sigma * r.transpose(), cell.strain_increment, settings, point);
      if (!settings.frozen)
        point.volume *= (1 + (cell.wet ? growth : cell.strain_increment.trace())) * (soil.wet ? 1 : 1 - update.opened);
      if (soil.wet) point.pressure = pressure, point.w = point.v;
      point.sigma = update.sigma;
      point.plastic_strain += update.plastic_strain;
      point.strain += cell.strain_increment;
      dilation += point.volume * find_dilation<D>(update);
      volume += point.volume;
    }
    if (cell.is_active()) body.plastic_dilation[e] = dilation / volume;
  }
}

/// One step of length Δt.
template <int D>
void step(MixtureBody<D>& body, const MixtureSettings& settings) {
  classify_wet_elements(body, settings);
  share_mixture_state(body);
  find_node_pressures(body);
  map_wet_points(body);
  add_wet_forces(body);
  load_free_surface(body);
  find_open_area(body);
  const Prediction<D> predicted = predict_motion(body, settings);
  const std::vector<ElementFlow> flow = solve_pressures(body, settings, predicted.velocity, predicted.acceleration);
  move_mixture(body, settings, predicted, flow);
  move_water(body, settings);
  compute_wet_increments(body, settings);
  update_mixture_points(body, settings);
  if (!settings.frozen) move_wet_points(body, settings);
  ++body.steps;
}

}  // namespace talus::reference
