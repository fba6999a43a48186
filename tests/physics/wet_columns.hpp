// SPDX-License-Identifier: MIT
#pragma once
// Columns of soil and water with closed-form solutions, for both plain steps.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/two_phase_bodies.hpp"

namespace talus::reference {

inline constexpr double water_weight = 1000 * 9.81;  ///< [N/m³]

/// (2.104): p/p0 at depth z/H.
inline double isochrone(double depth, double factor) {
  double sum = 0;
  for (int k = 1; k <= 200; ++k) {
    const double m = (2 * k - 1) * std::numbers::pi / 2;
    sum += 2 / m * std::sin(m * depth) * std::exp(-m * m * factor);
  }
  return sum;
}

/// A column of two layers of 1 m under water, fed at its bottom under 0.4 m more of head.
inline WetBody<2> make_layered_column(const Soil& loose, const Soil& tight, double jitter) {
  WetBody<2> body = make_column<2>(16, 0.125, loose, 0.4, jitter);
  body.soils = {loose, tight};
  body.points.clear();
  const auto hydrostatic = [](const Vector<2>& x) { return -water_weight * (2.1 - x[1]); };
  fill_wet(
      body, 0.3, 1, [](const Vector<2>& x) { return x[1] < 1; }, hydrostatic);
  fill_wet(
      body, 0.45, 0, [](const Vector<2>& x) { return x[1] > 1; }, hydrostatic);
  body.gravity[1] = -9.81;
  for (Constraint<2>& c : body.solid_constraints) c.fixed = {true, true};
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::head, .head = 2.1});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (body.mesh.nodes[i][1] == 0.0) {
      body.surface[i].head = 2.5;
      body.water_constraints[i].fixed[1] = false;
    }
  return body;
}

/// Gardner's soil: S = 0.2 + 0.8 exp(−a s), k_r = exp(−a s).
inline Soil make_gardner_soil(double a) {
  Soil soil = make_table_soil();
  soil.water.conductivity = 1e-4;
  soil.water.saturation = [=](double p) { return p > 0 ? 0.2 + 0.8 * std::exp(-a * p) : 1.0; };
  soil.water.saturation_slope = [=](double p) { return p > 0 ? -0.8 * a * std::exp(-a * p) : 0.0; };
  soil.water.relative_conductivity = [](double s) { return (s - 0.2) / 0.8; };
  return soil;
}

/// Richards' equation, ∂(nS)/∂t = −∂q/∂y with the upward flux q = k (∂p/∂y/γ_w − 1), by finite volumes of the water
/// content and small explicit steps; p = 0 at y = 0, q = −rain at the top. Returns p at the middles of the cells [Pa].
inline std::vector<double> solve_richards(const Soil& soil, double n, double height, int cells, double rain,
                                          double end) {
  const double h = height / cells, a = -std::log((soil.water.saturation(1.0) - 0.2) / 0.8);
  std::vector<double> p, content;
  for (int i = 0; i < cells; ++i) {
    p.push_back(water_weight * (i + 0.5) * h);
    content.push_back(soil.water.saturation(p.back()));
  }
  const auto k_at = [&](double pressure) { return soil.water.conductivity * std::exp(-a * std::max(pressure, 0.0)); };
  const double dt = 0.4 * h * h * n * 0.8 * a * water_weight / soil.water.conductivity / 2;
  const int steps = static_cast<int>(std::ceil(end / dt));
  std::vector<double> flux(static_cast<std::size_t>(cells) + 1);
  for (int s = 0; s < steps; ++s) {
    flux.back() = -rain;
    flux[0] = soil.water.conductivity * (p[0] / (h / 2) / water_weight - 1);
    for (std::size_t i = 1; i < p.size(); ++i)
      flux[i] = (k_at(p[i]) + k_at(p[i - 1])) / 2 * ((p[i] - p[i - 1]) / h / water_weight - 1);
    for (std::size_t i = 0; i < p.size(); ++i) {
      content[i] += end / steps / h / n * (flux[i] - flux[i + 1]);
      p[i] = -std::log((content[i] - 0.2) / 0.8) / a;
    }
  }
  return p;
}

}  // namespace talus::reference
