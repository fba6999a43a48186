// SPDX-License-Identifier: MIT
#pragma once
// The second half of the plain two-velocity step: strains and the divergence of the seepage (2.80, 2.81), their
// smoothing (2.94–2.97), water and pressure of every point (3.4), effective stresses (2.82), volumes and porosity
// (2.50).

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/plain_stress.hpp"
#include "reference/plain_two_phase_water.hpp"

namespace talus::reference {

/// Means over the nodes with the elements' `weights`, and back (2.94, 2.95). Elements of weight 0 take no part. The sum
/// of weight times value is kept.
template <int D>
std::vector<double> smooth_with_weights(const mesh::Mesh<D>& mesh, const std::vector<double>& weights,
                                        const std::vector<double>& field) {
  std::vector<double> sum(mesh.nodes.size(), 0), weight(mesh.nodes.size(), 0), smoothed(field.size(), 0);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int i = 0; i <= D; ++i) {
      at(sum, node_of(mesh, e, i)) += at(field, e) * at(weights, e);
      at(weight, node_of(mesh, e, i)) += at(weights, e);
    }
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int i = 0; i <= D && at(weights, e) > 0; ++i)
      at(smoothed, e) += at(sum, node_of(mesh, e, i)) / at(weight, node_of(mesh, e, i)) / (D + 1);
  return smoothed;
}

/// V_e of the elements whose volume change is averaged: those with points, unless their soil is separated.
template <int D>
std::vector<double> averaged_volumes(const WetBody<D>& body) {
  std::vector<double> weights(body.cells.size(), 0);
  for (std::size_t e = 0; e < body.cells.size(); ++e)
    if (body.cells[e].is_active() && !body.cells[e].apart) weights[e] = body.mesh.volumes[e];
  return weights;
}

/// Volume of the wet points of every element: Σ V_p, or as the element is integrated.
template <int D>
std::vector<double> wet_volumes(const WetBody<D>& body, bool as_integrated) {
  std::vector<double> weights(body.cells.size(), 0);
  for (const WetPoint<D>& point : body.points)
    if (soil_of(body, point).wet)
      at(weights, point.element) += (as_integrated ? at(body.cells, point.element).stretch : 1.0) * point.volume;
  return weights;
}

/// L and Δε of the solid, and div(θ(w−v)) with θ = n S of the nodes.
template <int D>
void compute_wet_increments(WetBody<D>& body, const WetSettings& settings) {
  std::vector<double> volumetric(body.cells.size(), 0), divergence(body.cells.size(), 0);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    WetCell& cell = at(body.cells, e);
    if (!cell.is_active()) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int i = 0; i <= D; ++i) {
      const WetNode<D>& node = at(body.nodes, node_of(body.mesh, e, i));
      cell.gradient.template topLeftCorner<D, D>() += node.v * b.row(i);
      if (cell.wet) cell.flux_divergence += node.water_content() * (node.w - node.v).dot(b.row(i));
    }
    cell.strain_increment = settings.time_step / 2 * (cell.gradient + cell.gradient.transpose());
    at(volumetric, e) = cell.strain_increment.trace();
    at(divergence, e) = cell.flux_divergence;
  }
  if (settings.smoothing == Smoothing::none) return;
  const std::vector<double> solid = find_smoothing_change(body, settings.smoothing, volumetric, [&](const auto& field) {
    return smooth_with_weights(body.mesh, averaged_volumes(body), field);
  });
  const std::vector<double> water = smooth_with_weights(body.mesh, wet_volumes(body, true), divergence);
  for (std::size_t e = 0; e < body.cells.size(); ++e) {
    body.cells[e].strain_increment += spread_volumetric<D>(solid[e]);
    body.cells[e].flux_divergence = water[e];
  }
}

/// Pressure smoothing (2.96, 2.97), applied to the source of the pressure, S tr Δε + Δt div(θ(w−v)). Where n, S and
/// K_w are uniform this is the smoothing of Δp; elsewhere, unlike that, it conserves water.
template <int D>
void smooth_water_increments(WetBody<D>& body, const WetSettings& settings) {
  if (!settings.smooth_pressure) return;
  const std::vector<double> weights = wet_volumes(body, false);
  std::vector<double> increment(body.cells.size(), 0);
  for (const WetPoint<D>& point : body.points) {
    if (!soil_of(body, point).wet) continue;
    const WetCell& cell = at(body.cells, point.element);
    at(increment, point.element) +=
        point.volume / at(weights, point.element) * cell.stretch *
        (soil_of(body, point).water.saturation(point.pressure) * cell.strain_increment.trace() +
         settings.time_step * cell.flux_divergence);
  }
  const std::vector<double> smoothed = smooth_with_weights(body.mesh, weights, increment);
  for (std::size_t e = 0; e < body.cells.size(); ++e) body.cells[e].surplus = smoothed[e] - increment[e];
}

/// Water, volume, pressure, effective stress and strain of every point.
template <int D>
void update_wet_points(WetBody<D>& body, const WetSettings& settings) {
  body.plastic_dilation.assign(body.cells.size(), 0);
  for (std::size_t e = 0; e < body.cells.size(); ++e) {
    const WetCell& cell = body.cells[e];
    double dilation = 0, volume = 0;
    const double volumetric = cell.strain_increment.trace();
    const Tensor r = settings.objective ? rotation_increment(cell.gradient, settings.time_step) : Tensor::Identity();
    for (std::size_t p : cell.points) {
      WetPoint<D>& point = body.points[p];
      const Soil& soil = soil_of(body, point);
      if (soil.wet) {
        double lost =
            settings.time_step * cell.stretch * cell.flux_divergence + cell.surplus;  // volume of water per volume
        // Frozen pores do not shrink; the water that they would press out is pressed into the rest.
        if (settings.frozen) lost += soil.water.saturation(point.pressure) * cell.stretch * volumetric;
        point.water_mass -= soil.water.density * point.volume * lost;
      }
      // The pores grow over the volume that the flux is integrated over: otherwise the work of pressures would not
      // balance.
      if (!settings.frozen) point.volume *= 1 + (soil.wet ? cell.stretch : 1.0) * volumetric;
      if (soil.wet && !cell.full)
        point.pressure = find_pressure(soil.water, pore_volume(body, point), point.water_mass, point.pressure);
      const StressUpdate update =
          update_moving_stress(soil.skeleton, r * point.sigma * r.transpose(), cell.strain_increment, settings, point);
      // Gaps of wet soil are pores: they fill with water and air.
      if (!settings.frozen && !soil.wet) point.volume *= 1 - update.opened;
      point.sigma = update.sigma;
      point.plastic_strain += update.plastic_strain;
      point.strain += cell.strain_increment;
      dilation += point.volume * find_dilation<D>(update);
      volume += point.volume;
    }
    if (cell.is_active()) body.plastic_dilation[e] = dilation / volume;
    if (cell.full && cell.wet) average_water(body, cell);
  }
}

}  // namespace talus::reference
