// SPDX-License-Identifier: MIT
#pragma once
// Exchange of water between neighbouring elements in the plain two-velocity step (T14.9).

#include <Eigen/Dense>
#include <algorithm>

#include "reference/plain_two_phase_strain.hpp"
#include "reference/plain_two_phase_surface.hpp"

namespace talus::reference {

/// Mean pressure [Pa], resistance ρ_w g/k [N s/m⁴] and storage of the water alone [m³/Pa] of an element that its wet
/// points fill.
struct ExchangeCell {
  bool takes_part = false;
  double pressure = 0, resistance = 0, storage = 0;
};

template <int D>
ExchangeCell make_exchange_cell(const WetBody<D>& body, const WetCell& cell, double element_volume) {
  ExchangeCell r;
  double volume = 0, mobile = 0;
  for (std::size_t i : cell.points) {
    const WetPoint<D>& point = body.points[i];
    const PoreWater& water = soil_of(body, point).water;
    if (!soil_of(body, point).wet) continue;
    const double p = point.pressure, s = water.saturation(p);
    volume += point.volume;
    r.pressure += point.volume * p;
    r.resistance += point.volume * water.density * water.drag_gravity / water.conductivity;
    mobile += point.volume * std::max(lowest_relative_conductivity, water.relative_conductivity(s));
    r.storage += point.water_mass / (water.density * water.bulk_modulus);
  }
  if (volume <= 0) return r;
  r.pressure /= volume;
  r.resistance /= mobile;
  r.takes_part = volume > full_share * element_volume;
  return r;
}

/// Darcy's flux of a node whose water has no inertia, with what holds it.
template <int D>
Vector<D> still_flux(const WetBody<D>& body, int number) {
  const WetNode<D>& node = at(body.nodes, number);
  if (node.water_mass <= 0) return Vector<D>::Zero();
  Vector<D> flux =
      at(body.water_constraints, number).apply(node.water_force) * node.mobile_volume / (node.resistance * node.volume);
  const SurfaceCondition<D> condition = surface_condition(body, number);
  const bool given = condition.kind == SurfaceKind::flux || condition.kind == SurfaceKind::closed;
  const bool drowned = condition.kind == SurfaceKind::head && submergence(body, number) > 0;
  if (node.surface.norm() == 0 || drowned || condition.kind == SurfaceKind::open ||
      condition.kind == SurfaceKind::pressure)
    return flux;
  const Vector<D> normal = node.surface.normalized();
  const double net = flux.dot(normal) - offered_flux(condition, node);
  if (net < 0 || given) flux -= net * normal;
  return flux;
}

/// Exchanges water across sides where the pressure difference of the centroids exceeds that of Darcy's law with the
/// fluxes of the side's nodes; each side is treated alone, at most 5 % of the smaller storage, every fourth step.
template <int D>
void exchange_water(WetBody<D>& body, const WetSettings& settings) {
  if (!settings.exchange_water || body.steps % 4 != 0) return;
  const auto& mesh = body.mesh;
  const double density = body.soils[0].water.density;
  std::vector<ExchangeCell> cells;
  for (int e = 0; e < mesh.element_count(); ++e)
    cells.push_back(make_exchange_cell(body, at(body.cells, e), at(mesh.volumes, e)));
  const auto place = [&](int node) {
    Vector<D> x;
    for (int d = 0; d < D; ++d) x[d] = at(at(mesh.nodes, node), d);
    return x;
  };
  const auto middle_of = [&](int e) {
    Vector<D> x = Vector<D>::Zero();
    for (int i = 0; i <= D; ++i) x += place(node_of(mesh, e, i)) / (D + 1);
    return x;
  };
  const std::vector<double> volume = wet_volumes(body, false);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const int n = at(at(mesh.neighbours, e), k);
      if (n < e || !at(cells, e).takes_part || !at(cells, n).takes_part) continue;
      const ExchangeCell &a = at(cells, e), &b = at(cells, n);
      Vector<D> side = Vector<D>::Zero(), flux = side;
      for (int i = 0; i <= D; ++i) {
        if (i == k) continue;
        side += place(node_of(mesh, e, i)) / D;
        flux += still_flux(body, node_of(mesh, e, i)) / D;
      }
      const Vector<D> first = side - middle_of(e), second = middle_of(n) - side;
      const double growth = b.pressure - a.pressure + density * body.gravity.dot(first + second);
      const double rest = growth - flux.dot(a.resistance * first + b.resistance * second);
      if (rest * growth <= 0) continue;
      const double area = D * at(mesh.volumes, e) * shape_gradients(mesh, e).row(k).norm();
      const double conductance = area / (a.resistance * first.norm() + b.resistance * second.norm());
      const double share = std::min(conductance * 4 * settings.time_step, 0.05 * std::min(a.storage, b.storage));
      const double passes = share * (std::abs(rest) < std::abs(growth) ? rest : growth);
      at(body.cells, e).surplus += passes / at(volume, e);
      at(body.cells, n).surplus -= passes / at(volume, n);
    }
}

}  // namespace talus::reference
