// SPDX-License-Identifier: MIT
#pragma once
// The derivatives of modified Cam-clay's return: the root is found in plain numbers, and one step of Newton's method
// in dual numbers from there moves nothing but carries the derivatives (implicit function theorem).

#include "base/dual.hpp"
#include "material/cam_clay_return.hpp"

namespace talus::material {

template <int N>
CamClayReturn<Dual<N>> search_cam_clay_return(const CamClayTrial<Dual<N>>& t) {
  using T = Dual<N>;
  const CamClayTrial<double> plain{t.pressure.value,        t.shear.value,     t.bulk.value,
                                   t.shear_stiffness.value, t.hardening.value, t.least_growth.value};
  const CamClayReturn<double> root = return_cam_clay<double>(plain, true);
  // ln of the growth, or what the hardening law would make of it below the floor
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
