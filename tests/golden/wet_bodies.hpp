// SPDX-License-Identifier: MIT
#pragma once
// Wet slopes for the comparison of the two-velocity step with its reference: in motion, and with every kind of
// condition.

#include <cmath>

#include "reference/wet_slope.hpp"

namespace talus::golden {

/// Sheared, with the water ahead of the grains, so that points change their elements within the few steps of a test.
template <int D>
reference::WetBody<D> set_in_motion(reference::WetBody<D> body, double rate) {
  for (auto& p : body.points) {
    p.v[0] = rate * p.x[1];
    p.v[1] = -0.1 * rate;
    if (!reference::soil_of(body, p).wet) continue;
    p.w = p.v;
    p.w[0] += 0.02 * std::sin(2 * p.x[0]);
    p.w[1] += 0.02 * std::cos(3 * p.x[1]);
  }
  return body;
}

/// Softer water for longer steps; the points keep their pressures.
template <int D>
reference::WetBody<D> soften(reference::WetBody<D> body, double bulk_modulus) {
  for (reference::Soil& soil : body.soils) soil.water.bulk_modulus = bulk_modulus;
  for (auto& p : body.points) {
    const reference::Soil& soil = reference::soil_of(body, p);
    if (soil.wet)
      p.water_mass = reference::pore_volume(body, p) * soil.water.saturation(p.pressure) *
                     reference::water_density(soil.water, p.pressure);
  }
  return body;
}

inline constexpr double soft_water = 2e7;

template <int D>
reference::WetBody<D> make_moving_slope(double rate = 1) {
  return set_in_motion(soften(reference::make_wet_slope<D>(), soft_water), rate);
}

template <int D>
double stable_step(const reference::WetBody<D>& body, reference::Drag drag = reference::Drag::implicit_at_nodes) {
  const auto soil = reference::CoupledSoil::saturated(5e6 * 0.7 / 0.52, 0.35, soft_water, 2650, 1e-5);
  return 0.4 * reference::critical_step(soil, reference::smallest_altitude(body.mesh), 1, drag);
}

/// Every kind of condition along the slope, from the crest to the toe: evaporation limited by suction, a given inflow,
/// an impervious skin, an open surface, rain, a positive and a negative given pressure, standing water.
template <int D>
reference::WetBody<D> make_many_conditions() {
  reference::WetBody<D> body = make_moving_slope<D>();
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    // Shifted along the third axis: the coarser mesh shall meet all of them as well.
    const double y = body.mesh.nodes[i][1],
                 x = body.mesh.nodes[i][0] + (D == 3 ? 0.5 * body.mesh.nodes[i][D - 1] : 0.0);
    auto& condition = body.surface[i];
    if (x < 1e-9 && y < 2.1) condition = {.kind = reference::SurfaceKind::pressure, .pressure = y < 1.1 ? -8e3 : 3e3};
    if (x < 1e-9) continue;
    if (x < 2.3) condition = {.kind = reference::SurfaceKind::rain, .evaporation = 3e-2, .suction_limit = 2.2e4};
    if (x > 2.3 && x < 3.3) condition = {.kind = reference::SurfaceKind::flux, .inflow = 1e-3};
    if (x > 3.3 && x < 3.8) condition = {.kind = reference::SurfaceKind::closed};
    if (x > 3.8 && x < 4.3) condition = {.kind = reference::SurfaceKind::open};
    if (x > 4.3 && x < 4.8) condition = {.kind = reference::SurfaceKind::rain, .normal_rain = 1e-3};
    if (x > 4.8 && x < 5.8) condition = {.kind = reference::SurfaceKind::pressure, .pressure = x < 5.3 ? -2e3 : 1e3};
    if (x > 5.8 && x < 6.3) condition = {.kind = reference::SurfaceKind::flux, .inflow = -1e-3};
    if (x > 6.3 && x < 6.8) condition = {.kind = reference::SurfaceKind::seepage};
  }
  return body;
}

}  // namespace talus::golden
