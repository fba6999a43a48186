// SPDX-License-Identifier: MIT
#pragma once
// The return mapping of modified Cam-clay to its ellipse (4.12-4.15) in dimensionless quantities: pressures over the
// trial p'_c, and the multiplier times it. The unknowns are d = Δλ p'_c and y, the logarithm of the growth of p'_c; p'
// and q follow from them:
//
//   P(d, y) = (P_t + k d c)/(1 + 2 k d),  R(d) = 1 + g d,  c = max(e^y, c_min)
//   0 = y - θ d (2P - c)                  hardening by plastic volume (4.15)
//   0 = Q_t/R² - P (c - P)                yield (4.1)
//
// Lanes use Newton's method from the trial state. Lanes that do not converge use a bracketed search on d alone.

#include <cmath>

#include "base/dual.hpp"
#include "base/lane.hpp"

namespace talus::material {

/// Trial state outside the ellipse, dimensionless.
template <class T>
struct CamClayTrial {
  T pressure;         ///< P_t = p'/p'_c, of either sign
  T shear;            ///< Q_t = q²/(M² p'_c²)
  T bulk;             ///< k = K/p'_c
  T shear_stiffness;  ///< g = 6G/(M² p'_c)
  T hardening;        ///< θ = (1+e)/(λ-κ)
  T least_growth;     ///< c_min <= 1, keeps p'_c above its floor
};

/// Result of the return.
template <class T>
struct CamClayReturn {
  T pressure;    ///< P
  T growth;      ///< c = e^y, growth of p'_c
  T shear;       ///< 1/R, ratio of q to that of the trial state
  T multiplier;  ///< d
};

/// Tolerance of |f|/p'_c² and of the residual of y.
inline constexpr double cam_clay_tolerance = 1e-10;

/// Residuals at (y, d) and the terms of Newton's step.
template <class T>
struct CamClayPoint {
  T pressure, distance, growth, slope;  ///< P, 2P - c, c, dc/dy
  T over_den, over_shear;               ///< 1/(1 + 2kd), 1/R
  T f, r;                               ///< residuals of yield and hardening

  TALUS_KERNEL CamClayPoint(const CamClayTrial<T>& t, T y, T d) {
    const T e = lane_exp(y), kd = t.bulk * d, den = 1.0 + 2.0 * kd, shear = 1.0 + t.shear_stiffness * d;
    growth = lane_max(e, t.least_growth);
    slope = select(e > t.least_growth, e, T(0.0));
    const T both = 1.0 / (den * shear);
    over_den = both * shear;
    over_shear = both * den;
    pressure = (t.pressure + kd * growth) * over_den;
    distance = (2.0 * t.pressure - growth) * over_den;
    f = t.shear * over_shear * over_shear - pressure * (growth - pressure);
    r = y - t.hardening * d * distance;
  }
};

/// Solves the hardening law for y at a given multiplier: the root of y + A c(y) - 2A P_t. The function increases and is
/// convex in y, so Newton's method converges monotonically from the right of the root.
TALUS_PORTABLE inline double find_growth_exponent(const CamClayTrial<double>& t, double d) {
  const double a = t.hardening * d / (1 + 2 * t.bulk * d);
  if (2 * t.pressure < t.least_growth && a * (2 * t.pressure - t.least_growth) < std::log(t.least_growth))
    return a * (2 * t.pressure - t.least_growth);  // p'_c is at its floor
  double y = 0;
  if (a * (1 - 2 * t.pressure) < 0) y = lane_min(2 * a * t.pressure, std::log(2 * t.pressure));
  for (int i = 0; i < 100; ++i) {
    const double c = std::exp(y), step = (y + a * (c - 2 * t.pressure)) / (1 + a * c);
    y -= step;
    if (!(std::abs(step) > 1e-15 * (1 + std::abs(y)))) break;
  }
  return y;
}

/// Solves the return by bracketing: slow, but it always terminates, with f <= 1e-10 p'_c².
TALUS_PORTABLE inline CamClayReturn<double> search_cam_clay_return(const CamClayTrial<double>& t) {
  const auto find = [&](double d) { return CamClayPoint<double>(t, find_growth_exponent(t, d), d); };
  // f is positive at d = 0 and tends to -c²/4 for large d, so there is a root between.
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
    const bool halves = i % 3 == 2;  // Newton's method alone may converge slowly from one side
    if (halves || !(d > low && d < high)) d = low + 0.5 * (high - low);
  }
  if (find(d).f > 1e-3 * cam_clay_tolerance * find(d).growth * find(d).growth) d = high;
  const CamClayPoint<double> at = find(d);
  return {at.pressure, at.growth, at.over_shear, d};
}

/// Solves the return for the lanes of `yields`; other lanes hold finite values if their trial state is finite.
template <class T>
TALUS_KERNEL CamClayReturn<T> return_cam_clay(const CamClayTrial<T>& t, MaskOf<T> yields) {
  if constexpr (requires { T::derivatives; })
    return search_cam_clay_return(t);  // the overload for dual numbers is below
  // Initial guess: the root of the expansion of f(d, y(d)) about the trial state by one third-order Chebyshev step,
  // which is accurate enough for the small increments of an explicit step. It has one exponential and saves one
  // division relative to Newton's method.
  const T n = 2.0 * t.pressure - 1.0, theta = select(t.least_growth < T(1.0), t.hardening, T(0.0));
  const T k_n = t.bulk * n, theta_n = theta * n, softening = 2.0 * t.bulk + theta, g_q = t.shear_stiffness * t.shear;
  const T f_0 = t.shear - t.pressure * (1.0 - t.pressure);
  const T over_f_1 = 1.0 / (2.0 * g_q + k_n * n + theta_n * t.pressure);  // reciprocal of minus the derivative of f
  const T f_2 = 3.0 * t.shear_stiffness * g_q + k_n * (n * softening + theta_n + k_n) -
                t.pressure * theta_n * (0.5 * theta_n - softening);
  T d = lane_max(f_0 * over_f_1, T(0.0));
  d += d * lane_max(T(-0.5), lane_min(T(1.0), f_2 * d * over_f_1));
  T y = theta_n * d / (1.0 + softening * d);
  auto open = yields;
  CamClayReturn<T> result{t.pressure, T(1.0), T(1.0), T(0.0)};
  constexpr int patience = 12;
  for (int i = 0; i < patience; ++i) {
    const CamClayPoint<T> at(t, y, d);
    const auto settled =
        lane_abs(at.f) < cam_clay_tolerance * at.growth * at.growth && lane_abs(at.r) < T(cam_clay_tolerance);
    const auto done = open && settled;
    result.pressure = select(done, at.pressure, result.pressure);
    result.growth = select(done, at.growth, result.growth);
    result.shear = select(done, at.over_shear, result.shear);
    result.multiplier = select(done, d, result.multiplier);
    open = open && !settled;
    if (!any(open)) return result;
    const T kd = t.bulk * d * at.over_den;
    const T r_y = 1.0 + t.hardening * d * at.over_den * at.slope, r_d = -t.hardening * at.distance * at.over_den;
    const T f_y = at.slope * (at.distance * kd - at.pressure);
    const T f_d = -2.0 * t.shear_stiffness * t.shear * at.over_shear * at.over_shear * at.over_shear -
                  t.bulk * at.distance * at.distance * at.over_den;
    const T step = (at.r * f_y - at.f * r_y) / (f_d * r_y - f_y * r_d);
    const T step_y = -(at.r + r_d * step) / r_y;
    d = lane_max(d + step, T(0.0));
    y += lane_max(T(-3.0), lane_min(T(3.0), step_y));
  }
  if constexpr (LaneTraits<T>::width == 1) {
    return search_cam_clay_return(t);
  } else {
    for (int l = 0; l < LaneTraits<T>::width; ++l) {
      if (!open[l]) continue;
      const auto found = search_cam_clay_return(
          {t.pressure[l], t.shear[l], t.bulk[l], t.shear_stiffness[l], t.hardening[l], t.least_growth[l]});
      result.pressure.value[l] = found.pressure;
      result.growth.value[l] = found.growth;
      result.shear.value[l] = found.shear;
      result.multiplier.value[l] = found.multiplier;
    }
    return result;
  }
}

// Derivatives of the return mapping: the root is found in double precision, and one step of Newton's method in dual
// numbers from there leaves the values unchanged and adds the derivatives (implicit function theorem).

template <int N>
CamClayReturn<Dual<N>> search_cam_clay_return(const CamClayTrial<Dual<N>>& t) {
  using T = Dual<N>;
  const CamClayTrial<double> plain{t.pressure.value,        t.shear.value,     t.bulk.value,
                                   t.shear_stiffness.value, t.hardening.value, t.least_growth.value};
  const CamClayReturn<double> root = return_cam_clay<double>(plain, true);
  // y is the logarithm of the growth, or the value of the hardening law where p'_c is at its floor.
  const double multiplier = root.multiplier;
  const double y_value =
      plain.hardening * multiplier * (2 * plain.pressure - root.growth) / (1 + 2 * plain.bulk * multiplier);
  const CamClayPoint<T> at(t, T(y_value), T(multiplier));
  const T kd = t.bulk * multiplier * at.over_den;
  const T r_y = 1.0 + t.hardening * multiplier * at.over_den * at.slope, r_d = -t.hardening * at.distance * at.over_den;
  const T f_y = at.slope * (at.distance * kd - at.pressure);
  const T f_d = -2.0 * t.shear_stiffness * t.shear * at.over_shear * at.over_shear * at.over_shear -
                t.bulk * at.distance * at.distance * at.over_den;
  const T step = (at.r * f_y - at.f * r_y) / (f_d * r_y - f_y * r_d);
  const CamClayPoint<T> moved(t, T(y_value) - (at.r + r_d * step) / r_y, T(multiplier) + step);
  return {moved.pressure, moved.growth, moved.over_shear, T(multiplier) + step};
}

}  // namespace talus::material
