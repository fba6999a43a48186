// SPDX-License-Identifier: MIT
#pragma once
// The water of points and elements: the pressure at which the pores contain it (3.4), the mean over the points of a
// full element, and its effect on the stress (3.12).

#include <cmath>

#include "reference/plain_two_phase_body.hpp"

namespace talus::reference {

/// ρ_w(p) of dρ_w/dp = −ρ_w/K_w (2.53) [kg/m³].
inline double water_density(const PoreWater& water, double pressure) {
  return water.density * std::exp(-pressure / water.bulk_modulus);
}

/// The pressure at which `pores` [m³] hold `mass` [kg] of water: S(p) ρ_w(p) = mass/pores. More than the pores hold at
/// p = 0 is compressed, in closed form; less is suction, by Newton's method kept between bounds by bisection, from
/// `guess` [Pa]. The retention curve must not rise with suction and be constant for p <= 0.
inline double find_pressure(const PoreWater& water, double pores, double mass, double guess) {
  const double content = mass / (pores * water.density), at_zero = water.saturation(0);
  if (content >= at_zero) return -water.bulk_modulus * std::log(content / at_zero);
  const auto excess = [&](double p) { return water.saturation(p) * std::exp(-p / water.bulk_modulus) - content; };
  // Without the retention curve the water would be stretched this far.
  double low = 0, high = water.bulk_modulus * std::log(at_zero / content);
  double p = guess > low && guess < high ? guess : std::min(1.0, high);
  for (int i = 0; i < 200; ++i) {
    const double f = excess(p);
    (f > 0 ? low : high) = p;
    const double slope = water.saturation_slope(p) - water.saturation(p) / water.bulk_modulus;
    double next = p - f / (slope * std::exp(-p / water.bulk_modulus));
    if (std::abs(next - p) <= 1e-9 * p) return next;  // it converges quadratically: what is left is round-off
    if (!(next > low && next < high)) next = low > 0 && high > 16 * low ? 4 * low : (low + high) / 2;
    p = next;
  }
  return p;
}

/// The points of a wet full element hold water as if there were no point: one pressure, at which the pores of all hold
/// the water of all, and the water in proportion to the pores. None is lost.
template <int D>
void average_water(WetBody<D>& body, const WetCell& cell) {
  double pressure = 0, volume = 0, water = 0, pores = 0;
  for (std::size_t i : cell.points) {
    const WetPoint<D>& point = body.points[i];
    pressure += point.volume * point.pressure;
    volume += point.volume;
    water += point.water_mass;
    pores += pore_volume(body, point);
  }
  const Soil& soil = soil_of(body, body.points[cell.points[0]]);
  const double shared = find_pressure(soil.water, pores, water, pressure / volume);
  for (std::size_t i : cell.points) {
    WetPoint<D>& point = body.points[i];
    point.pressure = shared;
    point.water_mass = water * pore_volume(body, point) / pores;
  }
}

/// Averages effective stress, plastic strain and gap over the points of each full element, weighted by V_p.
template <int D>
void average_skeleton_state(WetBody<D>& body, const WetCell& cell) {
  Tensor sigma = Tensor::Zero();
  double plastic_strain = 0, gap = 0, volume = 0;
  for (std::size_t i : cell.points) {
    const WetPoint<D>& point = body.points[i];
    sigma += point.volume * point.sigma;
    plastic_strain += point.volume * point.plastic_strain;
    gap += point.volume * point.gap;
    volume += point.volume;
  }
  for (std::size_t i : cell.points) {
    body.points[i].sigma = sigma / volume;
    body.points[i].plastic_strain = plastic_strain / volume;
    body.points[i].gap = gap / volume;
  }
}

/// The same for every full element, and the water.
template <int D>
void average_wet_state(WetBody<D>& body) {
  for (const WetCell& cell : body.cells) {
    if (!cell.full) continue;
    average_skeleton_state(body, cell);
    if (cell.wet) average_water(body, cell);
  }
}

/// χ of Bishop's stress: S (3.12), or with an air entry s_e that of Khalili and Khabbaz (1998), (s/s_e)^-0.55 above it.
inline double find_chi(const PoreWater& water, double pressure) {
  if (water.chi_air_entry <= 0) return water.saturation(pressure);
  return pressure <= water.chi_air_entry ? 1.0 : std::pow(pressure / water.chi_air_entry, -0.55);
}

/// σ' + χ p I of a point [Pa].
template <int D>
Tensor total_stress(const WetBody<D>& body, const WetPoint<D>& point) {
  const Soil& soil = soil_of(body, point);
  if (!soil.wet) return point.sigma;
  return point.sigma + find_chi(soil.water, point.pressure) * point.pressure * Tensor::Identity();
}

}  // namespace talus::reference
