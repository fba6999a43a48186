// SPDX-License-Identifier: MIT
#pragma once
// The plain semi-implicit step of the Darcy (u–p) formulation with continuous pore pressures: everything except the
// pressure is explicit, and the pressure at the end of the step satisfies the storage equation
// (docs/theory/22-mixture.md). The time step is limited by waves in the drained soil only.

#include <vector>

#include "reference/plain_mixture_pressure.hpp"
#include "reference/plain_two_phase.hpp"

namespace talus::reference {

/// v* and the acceleration that leads to it: the forces of the start of the step, damped, as far as the points see
/// them.
template <int D>
struct Prediction {
  std::vector<Vector<D>> velocity, acceleration, start;  ///< by node
};

template <int D>
Prediction<D> predict_motion(const DarcyBody<D>& body, const DarcySettings& settings) {
  Prediction<D> p;
  const std::vector<Vector<D>> zero(body.nodes.size(), Vector<D>::Zero());
  p.velocity = p.acceleration = p.start = zero;
  const std::vector<double> seen = find_seen(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const WetNode<D>& node = body.nodes[i];
    if (seen[i] == 0) continue;
    const double mass = darcy_mass(node);
    p.start[i] = (node.solid_momentum + node.water_momentum) / mass;
    const Vector<D> force =
        node.force + damp<D>(body.solid_constraints[i].apply(node.force), p.start[i], settings.damping);
    const Vector<D> moved =
        body.solid_constraints[i].hold(p.start[i] + settings.time_step / (settings.mass_scaling * mass) * force);
    p.acceleration[i] = seen[i] * (moved - p.start[i]) / settings.time_step;
    p.velocity[i] = body.solid_constraints[i].hold(p.start[i] + settings.time_step * p.acceleration[i]);
  }
  return p;
}

/// The velocity under the pressures of the end of the step, to the points and back (2.76–2.79).
template <int D>
void move_darcy(DarcyBody<D>& body, const DarcySettings& settings, const Prediction<D>& predicted,
                const std::vector<ElementFlow>& flow) {
  std::vector<double> change(body.nodes.size(), 0);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = body.water[i].change;
  const std::vector<Vector<D>> force = find_pressure_force(body, flow, change);
  const double limit = massless_limit(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    WetNode<D>& node = body.nodes[i];
    if (node.solid_mass <= limit) continue;
    const Vector<D> whole = node.force + force[i];
    const Vector<D> velocity = body.solid_constraints[i].hold(
        predicted.start[i] +
        settings.time_step / (settings.mass_scaling * darcy_mass(node)) *
            (whole + damp<D>(body.solid_constraints[i].apply(whole), predicted.start[i], settings.damping)));
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
    node.v = node.w = body.solid_constraints[i].hold(momentum[i] / darcy_mass(node));
  }
}

/// Outflow per pore volume of an element when `left` leaves its nodes [m³/m³].
template <int D>
std::vector<double> compute_outflow_per_pore(const DarcyBody<D>& body, const std::vector<double>& left) {
  std::vector<double> outflow(body.cells.size(), 0);
  for (int e = 0; e < body.mesh.element_count(); ++e)
    for (int i = 0; i <= D && at(body.cells, e).wet; ++i) {
      const int node = node_of(body.mesh, e, i);
      at(outflow, e) += at(left, node) / at(body.water, node).pores / (D + 1);
    }
  return outflow;
}

/// Size of the elements round each node [m].
template <int D>
std::vector<double> find_node_sizes(const mesh::Mesh<D>& mesh) {
  std::vector<double> volume(mesh.nodes.size(), 0), count(volume);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int i = 0; i <= D; ++i) {
      at(volume, node_of(mesh, e, i)) += at(mesh.volumes, e);
      at(count, node_of(mesh, e, i)) += 1;
    }
  for (std::size_t i = 0; i < volume.size(); ++i)
    volume[i] = std::pow((D == 2 ? 2 : 6) * volume[i] / count[i], 1.0 / D);
  return volume;
}

/// Updates the nodal remainder (T22.7): outflow of the nodes that their elements do not represent. It decays as the
/// soil moves over the size of an element.
template <int D>
void keep_own_water(DarcyBody<D>& body, const DarcySettings& settings, const std::vector<double>& outflow,
                    const std::vector<Vector<D>>& velocity) {
  for (std::size_t i = 0; i < body.own.size(); ++i) body.own[i] -= body.water[i].out;
  for (std::size_t e = 0; e < body.cells.size(); ++e)
    for (std::size_t p : body.cells[e].points) {
      const WetPoint<D>& point = body.points[p];
      if (!soil_of(body, point).wet || !body.cells[e].wet) continue;
      for (int i = 0; i <= D; ++i)
        at(body.own, node_of(body.mesh, static_cast<int>(e), i)) += find_pores(body, point) * outflow[e] / (D + 1);
    }
  const std::vector<double> size = find_node_sizes(body.mesh);
  for (std::size_t i = 0; i < body.own.size() && !settings.frozen; ++i)
    body.own[i] *= std::max(0.0, 1 - settings.time_step * velocity[i].norm() / size[i]);
}

/// Takes the outflow of the nodes from the elements, in proportion to their pores (T22.6), and updates the budget.
/// Elements lose as much as the nodes: the water is conserved.
template <int D>
void move_water(DarcyBody<D>& body, const DarcySettings& settings, const std::vector<Vector<D>>& velocity) {
  for (const WetCell& cell : body.cells) {
    if (!cell.full || !cell.wet) continue;
    const ElementWater water = find_element_water(body, cell);
    for (std::size_t p : cell.points) {
      WetPoint<D>& point = body.points[p];
      point.water_mass = soil_of(body, point).water.density * water.water * find_pores(body, point) / water.pores;
    }
  }
  std::vector<double> out;
  for (const WaterNode& node : body.water) out.push_back(node.out);
  const std::vector<double> outflow = compute_outflow_per_pore(body, out);
  keep_own_water(body, settings, outflow, velocity);
  for (std::size_t e = 0; e < body.cells.size(); ++e)
    for (std::size_t p : body.cells[e].points) {
      WetPoint<D>& point = body.points[p];
      if (soil_of(body, point).wet)
        point.water_mass -= soil_of(body, point).water.density * find_pores(body, point) * outflow[e];
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

/// Velocity of the water in the pores against the grains, by element, at the pressures of the end of the step.
template <int D>
std::vector<Vector<D>> find_seeping(const DarcyBody<D>& body, const std::vector<ElementFlow>& flow,
                                    const std::vector<Vector<D>>& acceleration) {
  std::vector<Vector<D>> seeping(body.cells.size(), Vector<D>::Zero());
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    const WetCell& cell = at(body.cells, e);
    const double water = cell.wet ? find_element_water(body, cell).water : 0;
    if (!(water > 0)) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    Vector<D> darcy = at(flow, e).water_weight * body.gravity;  // times the volume
    for (int i = 0; i <= D; ++i) {
      const int node = node_of(body.mesh, e, i);
      darcy += at(flow, e).conductive * (at(body.pressure, node) + at(body.water, node).change) * b.row(i).transpose() -
               at(flow, e).water_weight * at(acceleration, node) / (D + 1);
    }
    at(seeping, e) = darcy / (cell.stretch * water);
  }
  return seeping;
}

/// Volumes, effective stresses and pressures of the points.
template <int D>
void update_mixture_points(DarcyBody<D>& body, const DarcySettings& settings, const std::vector<Vector<D>>& seeping) {
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
      if (soil.wet) point.pressure = pressure, point.w = point.v + seeping[e];
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
void step(DarcyBody<D>& body, const DarcySettings& settings) {
  classify_wet_elements(body, settings);
  for (const WetCell& cell : body.cells)
    if (cell.full) average_skeleton_state<D>(body, cell);
  find_node_pressures(body);
  map_wet_points(body);
  add_wet_forces(body);
  load_free_surface(body);
  find_open_area(body);
  const Prediction<D> predicted = predict_motion(body, settings);
  const std::vector<ElementFlow> flow = solve_pressures(body, settings, predicted.velocity, predicted.acceleration);
  move_darcy(body, settings, predicted, flow);
  const std::vector<Vector<D>> seeping = find_seeping(body, flow, predicted.acceleration);
  move_water(body, settings, predicted.velocity);
  compute_wet_increments(body, settings);
  update_mixture_points(body, settings, seeping);
  if (!settings.frozen) move_wet_points(body, settings);
  ++body.steps;
}

}  // namespace talus::reference
