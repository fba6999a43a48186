// SPDX-License-Identifier: MIT
#include "material/cam_clay_return.hpp"

#include <algorithm>
#include <cmath>

namespace talus::material {
namespace {

/// y of the hardening law at a given multiplier: the root of y + A c(y) - 2A P_t, which rises and is convex in y, so
/// that Newton's method from the right of it comes down to it.
double find_growth_exponent(const CamClayTrial<double>& t, double d) {
  const double a = t.hardening * d / (1 + 2 * t.bulk * d);
  if (2 * t.pressure < t.least_growth && a * (2 * t.pressure - t.least_growth) < std::log(t.least_growth))
    return a * (2 * t.pressure - t.least_growth);  // p'_c has come down to its floor
  double y = 0;
  if (a * (1 - 2 * t.pressure) < 0) y = std::min(2 * a * t.pressure, std::log(2 * t.pressure));
  for (int i = 0; i < 100; ++i) {
    const double c = std::exp(y), step = (y + a * (c - 2 * t.pressure)) / (1 + a * c);
    y -= step;
    if (!(std::abs(step) > 1e-15 * (1 + std::abs(y)))) break;
  }
  return y;
}

}  // namespace

CamClayReturn<double> search_cam_clay_return(const CamClayTrial<double>& t) {
  const auto find = [&](double d) { return CamClayPoint<double>(t, find_growth_exponent(t, d), d); };
  // f is positive at d = 0 and tends to -c²/4 for large d: between them it has a root.
  const double n = 2 * t.pressure - 1;
  double low = 0;
  double high = (t.shear - t.pressure * (1 - t.pressure)) / (2 * t.shear_stiffness * t.shear + t.bulk * n * n);
  if (!(high > 1e-300)) high = 1e-300;
  for (int i = 0; i < 2000 && !(find(high).f <= 0); ++i) {
    low = high;
    high *= 2;
  }
  double d = high;
  for (int i = 0; i < 300; ++i) {
    const CamClayPoint<double> at = find(d);
    if (std::abs(at.f) <= 1e-3 * cam_clay_tolerance * at.growth * at.growth || !(high - low > 4e-16 * high)) break;
    (at.f > 0 ? low : high) = d;
    const double r_y = 1 + t.hardening * d * at.over_den * at.slope;
    const double r_d = -t.hardening * at.distance * at.over_den;
    const double f_y = at.slope * (at.distance * t.bulk * d * at.over_den - at.pressure);
    const double f_d = -2 * t.shear_stiffness * t.shear * at.over_shear * at.over_shear * at.over_shear -
                       t.bulk * at.distance * at.distance * at.over_den;
    const double slope = f_d - f_y * r_d / r_y;
    d -= at.f / slope;
    const bool halves = i % 3 == 2;  // Newton's method alone may creep from one side
    if (halves || !(d > low && d < high)) d = low + 0.5 * (high - low);
  }
  if (find(d).f > 1e-3 * cam_clay_tolerance * find(d).growth * find(d).growth) d = high;
  const CamClayPoint<double> at = find(d);
  return {at.pressure, at.growth, at.over_shear, d};
}

}  // namespace talus::material
