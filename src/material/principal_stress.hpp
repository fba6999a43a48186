// SPDX-License-Identifier: MIT
#pragma once
// Closed-form principal stresses and recomposition of the tensor, without eigenvectors, trigonometric functions or
// branches.
//
// Three dimensions: with p the mean stress, q = √(J2/3) and t = cos3θ = J3/(2q³), s1 = p + 2q·c(t) and s3 = p -
// 2q·c(-t), where c(t) = cos(acos(t)/3) = cos(⅔ acos u), u = √((1+t)/2). On u in [0, 1] this function is analytic, and
// a polynomial of degree 16 approximates it to 1.1e-15. The tensor with principal values n_i and the directions of σ is
// composed by divided differences (Newton's form of the spectral polynomial), exact also for equal principal values.

#include <array>

#include "base/lane.hpp"

namespace talus::material {

/// Coefficients a_k of Σ a_k u^k ≈ cos(⅔ acos u) on [0, 1]: interpolation in Chebyshev points, computed at first use.
struct CosineThird {
  static constexpr int degree = 16;
  std::array<double, degree + 1> a{};
  CosineThird();

  template <class T>
  TALUS_KERNEL T operator()(T u) const {
    T s(a[degree]);
    TALUS_UNROLL
    for (int k = degree - 1; k >= 0; --k) s = s * u + a[static_cast<std::size_t>(k)];
    return s;
  }
};

/// Principal stresses in plane strain: A >= B in the plane, sigma[2] out of plane.
template <class T>
struct PlanePrincipal {
  T mean, half_difference, radius, out_of_plane;  ///< (σx+σy)/2, (σx-σy)/2, Mohr's radius, σz [Pa]
  T s1, s2, s3;                                   ///< s1 >= s2 >= s3 [Pa]

  TALUS_KERNEL explicit PlanePrincipal(const T* sigma)
      : mean(0.5 * (sigma[0] + sigma[1])),
        half_difference(0.5 * (sigma[0] - sigma[1])),
        radius(lane_sqrt(half_difference * half_difference + sigma[3] * sigma[3])),
        out_of_plane(sigma[2]) {
    const T a = mean + radius, b = mean - radius;
    s1 = lane_max(a, out_of_plane);
    s3 = lane_min(b, out_of_plane);
    s2 = lane_max(b, lane_min(a, out_of_plane));
  }

  /// Writes the stress with principal values n1, n2, n3 (in the order of s1, s2, s3) and unchanged directions.
  TALUS_KERNEL void compose(T n1, T n2, T n3, T* sigma) const {
    const auto z_first = out_of_plane > mean + radius;
    const auto z_last = out_of_plane < mean - radius;
    const T a = select(z_first, n2, n1), b = select(z_last, n2, n3);
    const T z = select(z_first, n1, select(z_last, n3, n2));
    const T new_mean = 0.5 * (a + b), new_radius = 0.5 * (a - b);
    const T tiny(1e-30);
    const T scale = select(radius > tiny, new_radius / (radius + tiny), T(0.0));
    sigma[0] = new_mean + half_difference * scale;
    sigma[1] = new_mean - half_difference * scale;
    sigma[2] = z;
    sigma[3] = sigma[3] * scale;
  }
};

/// Principal stresses in three dimensions.
template <class T>
struct SpacePrincipal {
  T p, q;              ///< mean stress and √(J2/3) [Pa]
  T dev[3], shear[3];  ///< diagonal of the deviator; xy, yz, zx [Pa]
  T d1, d2, d3;        ///< principal deviators, decreasing [Pa]
  T s1, s2, s3;        ///< s1 >= s2 >= s3 [Pa]

  TALUS_KERNEL SpacePrincipal(const T* sigma, const CosineThird& cosine) {
    p = (sigma[0] + sigma[1] + sigma[2]) * (1.0 / 3);
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) {
      dev[i] = sigma[i] - p;
      shear[i] = sigma[3 + i];
    }
    const T xy2 = shear[0] * shear[0], yz2 = shear[1] * shear[1], zx2 = shear[2] * shear[2];
    const T j2 = 0.5 * (dev[0] * dev[0] + dev[1] * dev[1] + dev[2] * dev[2]) + xy2 + yz2 + zx2;
    const T j3 = dev[0] * (dev[1] * dev[2] - yz2) - dev[1] * zx2 - dev[2] * xy2 + 2.0 * shear[0] * shear[1] * shear[2];
    q = lane_sqrt(j2 * (1.0 / 3));
    const T t = lane_max(T(-1.0), lane_min(T(1.0), j3 * 0.5 / (q * q * q + 1e-30)));
    d1 = 2.0 * q * cosine(lane_sqrt(0.5 * (1.0 + t)));
    d3 = -2.0 * q * cosine(lane_sqrt(0.5 * (1.0 - t)));
    d2 = lane_max(d3, lane_min(d1, -d1 - d3));
    s1 = p + d1;
    s2 = p + d2;
    s3 = p + d3;
  }

  /// Writes the stress with principal values n1, n2, n3 (in the order of s1, s2, s3) and unchanged directions.
  TALUS_KERNEL void compose(T n1, T n2, T n3, T* sigma) const {
    const T tiny(1e-30), equal = 1e-12 * (q + lane_abs(p));
    const T e12 = d1 - d2, e23 = d2 - d3, e13 = d1 - d3;
    const T g12 = select(e12 > equal, (n1 - n2) / (e12 + tiny), T(0.0));
    const T g23 = select(e23 > equal, (n2 - n3) / (e23 + tiny), T(0.0));
    const T g123 = select(e13 > equal, (g12 - g23) / (e13 + tiny), T(0.0));
    // n1 I + g12 (S-d1) + g123 (S-d1)(S-d2) with S the deviator
    const T c1 = g12 - g123 * (d1 + d2), c0 = n1 - g12 * d1 + g123 * d1 * d2;
    const T xy = shear[0], yz = shear[1], zx = shear[2];
    const T square[6] = {dev[0] * dev[0] + xy * xy + zx * zx, xy * xy + dev[1] * dev[1] + yz * yz,
                         zx * zx + yz * yz + dev[2] * dev[2], xy * (dev[0] + dev[1]) + zx * yz,
                         yz * (dev[1] + dev[2]) + xy * zx,    zx * (dev[0] + dev[2]) + xy * yz};
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) sigma[i] = c0 + c1 * dev[i] + g123 * square[i];
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) sigma[3 + i] = c1 * shear[i] + g123 * square[3 + i];
  }
};

}  // namespace talus::material
