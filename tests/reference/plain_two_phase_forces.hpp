// SPDX-License-Identifier: MIT
#pragma once
// The first half of the plain two-velocity step: full elements, sides open to water, and the nodal sums.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/plain_mpm.hpp"
#include "reference/plain_two_phase_water.hpp"

namespace talus::reference {

/// Below this fraction of the saturated conductivity water counts as immobile; zero would be an infinite drag.
inline constexpr double lowest_relative_conductivity = 1e-12;

/// As classify_elements() of one phase; an element is wet when one of its points is.
template <int D>
void classify_wet_elements(WetBody<D>& body, const WetSettings& settings) {
  body.cells.assign(body.mesh.elements.size(), {});
  for (std::size_t p = 0; p < body.points.size(); ++p) at(body.cells, body.points[p].element).points.push_back(p);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    WetCell& cell = at(body.cells, e);
    if (!cell.is_active()) continue;
    double volume = 0;
    bool one_material = true, at_free_surface = false;
    for (std::size_t p : cell.points) {
      volume += body.points[p].volume;
      cell.wet = cell.wet || soil_of(body, body.points[p]).wet;
      if (body.points[p].material != body.points[cell.points[0]].material) one_material = false;
    }
    for (int neighbour : at(body.mesh.neighbours, e))
      if (neighbour >= 0 && !at(body.cells, neighbour).is_active()) at_free_surface = true;
    cell.full = settings.mixed && one_material && (!at_free_surface || volume > full_share * at(body.mesh.volumes, e));
    if (cell.full) cell.stretch = at(body.mesh.volumes, e) / volume;
  }
  note_gaps(body, settings);
}

/// Masses (2.68)–(2.70), momenta, gravity and the drag coefficient (2.75).
template <int D>
void map_wet_points(WetBody<D>& body) {
  body.nodes.assign(body.mesh.nodes.size(), {});
  for (const WetPoint<D>& point : body.points) {
    const Soil& soil = soil_of(body, point);
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    const Gradients<D> b = shape_gradients(body.mesh, point.element);
    const double s = soil.wet ? soil.water.saturation(point.pressure) : 0.0;
    for (int i = 0; i <= D; ++i) {
      WetNode<D>& node = at(body.nodes, node_of(body.mesh, point.element, i));
      node.solid_mass += n[i] * point.mass;
      node.solid_momentum += n[i] * point.mass * point.v;
      node.force += n[i] * (point.mass + point.water_mass) * body.gravity;
      if (!soil.wet) continue;
      const double k =
          soil.water.conductivity * std::max(lowest_relative_conductivity, soil.water.relative_conductivity(s));
      const double whole = n[i] * soil.water.density * point.volume;
      node.water_mass += n[i] * point.water_mass;
      node.water_momentum += n[i] * point.water_mass * point.w;
      node.whole_mass += whole;
      node.water_force += whole * body.gravity;
      node.resistance += whole * soil.water.drag_gravity / soil.water.conductivity;
      node.mobile_volume += n[i] * point.volume * k / soil.water.conductivity;
      node.volume += n[i] * point.volume;
      const Vector<D> outside = at(body.cells, point.element).stretch * point.volume * b.row(i).transpose();
      node.outside += outside;
      node.outside_scale += outside.cwiseAbs().sum();
    }
  }
}

/// Takes the internal forces (2.73), (2.74), (2.92) off and adds the given tractions.
template <int D>
void add_wet_forces(WetBody<D>& body) {
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    const WetCell& cell = at(body.cells, e);
    if (!cell.is_active()) continue;
    Tensor stress = Tensor::Zero();
    double pressure = 0;
    for (std::size_t p : cell.points) {
      const WetPoint<D>& point = body.points[p];
      const double volume = cell.stretch * point.volume;
      stress += volume * total_stress(body, point);
      if (soil_of(body, point).wet) pressure += volume * point.pressure;
    }
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int i = 0; i <= D; ++i) {
      WetNode<D>& node = at(body.nodes, node_of(body.mesh, e, i));
      node.force -= stress.template topLeftCorner<D, D>() * b.row(i).transpose();
      node.water_force -= pressure * b.row(i).transpose();
    }
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    if (!body.tractions.empty()) body.nodes[i].force += body.tractions[i];
    if (!body.water_tractions.empty()) body.nodes[i].water_force += body.water_tractions[i];
  }
}

}  // namespace talus::reference
