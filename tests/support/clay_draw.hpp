// SPDX-License-Identifier: MIT
#pragma once
// Random Cam-clay soils, their states and strain increments, over the whole range that occurs in slopes.

#include "support/clay_point.hpp"
#include "support/draw.hpp"

namespace talus::support {

inline double draw_logarithmic(Draw& draw, double from, double to) {
  return std::exp(draw(std::log(from), std::log(to)));
}

/// Soil with roots; every third is reduced, every third breaks its roots.
inline material::RootedCamClay draw_soil(Draw& draw) {
  material::CamClayParameters soil;
  soil.compression = draw(0.03, 0.4);
  soil.swelling = soil.compression * draw(0.03, 0.6);
  soil.poisson_ratio = draw(0, 0.45);
  soil.critical_state_slope = draw(0.4, 1.9);
  soil.suction_hardening = draw(0, 15);
  soil.smallest_pressure = draw_logarithmic(draw, 10, 1e4);
  soil.strength_factor = draw(0, 3) < 1 ? draw(0.7, 3) : 1;
  material::RootParameters roots{.hardening = draw(0, 0.5), .strength = draw(0, 0.3)};
  if (draw(0, 3) < 1) {
    roots.breaking_strain = draw(0, 0.1);
    roots.breaking_range = draw(0.01, 0.1);
    roots.residual_share = draw(0, 0.5);
  }
  return material::RootedCamClay(soil, roots);
}

/// M_r of a point, by the trigonometry of its friction angle.
inline double find_slope(const material::RootedCamClay& law, const double* state) {
  const double m = law.soil().critical_state_slope + law.roots().strength * state[3] * state[6];
  if (law.soil().strength_factor == 1) return m;
  const double phi = std::asin(std::min(3 * m / (6 + m), 0.9999));
  const double reduced = std::atan(std::tan(phi) / law.soil().strength_factor);
  return 6 * std::sin(reduced) / (3 - std::sin(reduced));
}

/// Components drawn in [-1, 1], of the given size as √(ε:ε).
template <int NS>
std::array<double, NS> draw_increment(Draw& draw, double size) {
  std::array<double, NS> d{};
  double square = 0;
  for (std::size_t i = 0; i < NS; ++i) {
    d[i] = draw(-1, 1);
    square += (i < 3 ? 1 : 0.5) * d[i] * d[i];
  }
  if (NS == 4) {
    square -= d[2] * d[2];
    d[2] = 0;
  }
  for (double& component : d) component *= size / std::sqrt(square);
  return d;
}

/// A point on or within its ellipse, now and then at the apex or far out of the surface.
template <int NS>
ClayPoint<NS, true> draw_clay_point(Draw& draw, const material::RootedCamClay& law) {
  ClayPoint<NS, true> point;
  point.saturation = draw(0.3, 1);
  const double p_b = draw_logarithmic(draw, 1e-3 * law.soil().smallest_pressure, 1e7);
  const std::array<double, NS> nothing{};
  law.set_initial_state(nothing.data(), draw(0.1, 2), draw(0, 2), p_b, point.saturation, point.state.data());
  point.state[5] = draw(-0.05, 0.2);
  point.state[6] = draw(0, 1);
  const double p_c = law.find_preconsolidation(point.state.data(), point.saturation);
  const double p = p_c * (draw(0, 1) < 0.3 ? draw_logarithmic(draw, 1e-8, 1) : draw(0, 1));
  double q = find_slope(law, point.state.data()) * std::sqrt(p * (p_c - p));
  if (draw(0, 1) < 0.5) q *= draw(0, 1);
  if (draw(0, 1) < 0.05) q *= draw_logarithmic(draw, 1, 100);
  auto s = draw_increment<NS>(draw, 1);
  const double mean = (s[0] + s[1] + s[2]) / 3;
  double square = 0;
  for (std::size_t i = 0; i < NS; ++i) {
    if (i < 3) s[i] -= mean;
    square += (i < 3 ? 1 : 2) * s[i] * s[i];
  }
  for (std::size_t i = 0; i < NS; ++i) point.stress[i] = s[i] * q / std::sqrt(1.5 * square) - (i < 3 ? p : 0);
  return point;
}

}  // namespace talus::support
