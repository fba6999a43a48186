// SPDX-License-Identifier: MIT
#pragma once
// Kernels of one element and its points in a step: motion (G2P), stress rotation, sums over the points (P2G) and remap.
// They are templates on T: a Pack (one element per lane) on the CPU, a double on a GPU. Symbols are those of
// docs/notation.md.

#include "base/lane.hpp"
#include "material/linear_elastic.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Motion of an element in one step, affine in the local coordinates (T2.1, T2.2): the value at ξ is first + Σ_k
/// slope[k] ξ_k.
template <int D, class T>
struct ElementMotion {
  T dv_first[D], dv_slope[D][D];    ///< Δt a: velocity change of a point [m/s]
  T dxi_first[D], dxi_slope[D][D];  ///< change of local coordinates [-], [k][j]: ∂Δξ_j/∂ξ_k
  T grad[D][D];                     ///< Δt ∂v_i/∂x_j [-]

  TALUS_KERNEL ElementMotion(const T a[D + 1][D], const T v[D + 1][D], const T* g, double dt) {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      dv_first[d] = a[0][d] * dt;
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) dv_slope[k][d] = (a[k + 1][d] - a[0][d]) * dt;
    }
    T difference[D][D];
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) difference[k][d] = (v[k + 1][d] - v[0][d]) * dt;
    }
    TALUS_UNROLL
    for (int j = 0; j < D; ++j) {
      T first = g[j * D] * v[0][0];
      TALUS_UNROLL
      for (int d = 1; d < D; ++d) first += g[j * D + d] * v[0][d];
      dxi_first[j] = first * dt;
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) {
        T slope = g[j * D] * difference[k][0];
        TALUS_UNROLL
        for (int d = 1; d < D; ++d) slope += g[j * D + d] * difference[k][d];
        dxi_slope[k][j] = slope;
      }
    }
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) {
      TALUS_UNROLL
      for (int j = 0; j < D; ++j) {
        T s = difference[0][i] * g[j];
        TALUS_UNROLL
        for (int k = 1; k < D; ++k) s += difference[k][i] * g[k * D + j];
        grad[i][j] = s;
      }
    }
  }

  /// Strain increment (2.43); shear components are engineering strains.
  TALUS_KERNEL void strain(T* d_epsilon) const {
    d_epsilon[0] = grad[0][0];
    d_epsilon[1] = grad[1][1];
    d_epsilon[3] = grad[0][1] + grad[1][0];
    if constexpr (D == 2) {
      d_epsilon[2] = T(0.0);
    } else {
      d_epsilon[2] = grad[2][2];
      d_epsilon[4] = grad[1][2] + grad[2][1];
      d_epsilon[5] = grad[2][0] + grad[0][2];
    }
  }

  TALUS_KERNEL void advance_position(T* xi) const {
    T next[D];
    TALUS_UNROLL
    for (int j = 0; j < D; ++j) {
      T s = xi[j] + dxi_first[j];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) s += dxi_slope[k][j] * xi[k];
      next[j] = s;
    }
    TALUS_UNROLL
    for (int j = 0; j < D; ++j) xi[j] = next[j];
  }
  TALUS_KERNEL void advance_velocity(const T* xi, T* velocity) const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      T s = velocity[d] + dv_first[d];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) s += dv_slope[k][d] * xi[k];
      velocity[d] = s;
    }
  }
};

/// Rotation of the stress in one step, R = (I-W/2)⁻¹(I+W/2) with the spin W (Hughes and Winget 1980; T7.1). R is
/// exactly orthogonal, so principal stresses are unchanged.
template <int D, class T>
struct Rotation;

template <class T>
struct Rotation<2, T> {
  T cosine, sine;        ///< of twice the angle
  Rotation() = default;  ///< uninitialised; must not be applied
  TALUS_KERNEL explicit Rotation(const T grad[2][2]) {
    const T t = 0.25 * (grad[0][1] - grad[1][0]);  // W_xy / 2 = tan(half the angle)
    const T scale = 1.0 / (1.0 + t * t);
    const T c = (1.0 - t * t) * scale, s = 2.0 * t * scale;
    cosine = c * c - s * s;
    sine = 2.0 * c * s;
  }
  TALUS_KERNEL void apply(T* sigma) const {
    const T mean = 0.5 * (sigma[0] + sigma[1]), half = 0.5 * (sigma[0] - sigma[1]);
    const T turned = cosine * half + sine * sigma[3];
    sigma[3] = cosine * sigma[3] - sine * half;
    sigma[0] = mean + turned;
    sigma[1] = mean - turned;
  }
};

template <class T>
struct Rotation<3, T> {
  T r[3][3];
  Rotation() = default;
  TALUS_KERNEL explicit Rotation(const T grad[3][3]) {
    // axial vector of W/2: (W/2) x = a × x, then R = ((1-a²) I + 2aaᵀ + 2[a]×) / (1+a²)  (Cayley)
    const T a[3] = {0.25 * (grad[2][1] - grad[1][2]), 0.25 * (grad[0][2] - grad[2][0]),
                    0.25 * (grad[1][0] - grad[0][1])};
    const T square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const T scale = 1.0 / (1.0 + square);
    const T diagonal = (1.0 - square) * scale, twice = 2.0 * scale;
    const T cross[3] = {twice * a[0], twice * a[1], twice * a[2]};
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) {
      TALUS_UNROLL
      for (int j = 0; j < 3; ++j) r[i][j] = twice * a[i] * a[j];
      r[i][i] += diagonal;
    }
    r[0][1] -= cross[2];
    r[1][0] += cross[2];
    r[1][2] -= cross[0];
    r[2][1] += cross[0];
    r[2][0] -= cross[1];
    r[0][2] += cross[1];
  }
  TALUS_KERNEL void apply(T* sigma) const {
    const T s[3][3] = {{sigma[0], sigma[3], sigma[5]}, {sigma[3], sigma[1], sigma[4]}, {sigma[5], sigma[4], sigma[2]}};
    T rs[3][3];
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) {
      TALUS_UNROLL
      for (int j = 0; j < 3; ++j) rs[i][j] = r[i][0] * s[0][j] + r[i][1] * s[1][j] + r[i][2] * s[2][j];
    }
    constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
    TALUS_UNROLL
    for (int c = 0; c < 6; ++c) {
      const int i = row[c], j = column[c];
      sigma[c] = rs[i][0] * r[j][0] + rs[i][1] * r[j][1] + rs[i][2] * r[j][2];
    }
  }
};

/// Smallest of the D+1 shape functions; negative outside the element.
template <int D, class T>
TALUS_KERNEL T smallest_shape(const T* xi) {
  T sum = xi[0], smallest = xi[0];
  TALUS_UNROLL
  for (int k = 1; k < D; ++k) {
    sum += xi[k];
    smallest = lane_min(smallest, xi[k]);
  }
  return lane_min(smallest, T(1.0) - sum);
}

/// Stress components that enter the internal force: xx yy xy, or all six.
template <int D>
inline constexpr int force_size = D == 2 ? 3 : 6;
template <int D>
TALUS_KERNEL constexpr int force_component(int i) {
  return D == 2 && i == 2 ? 3 : i;
}

/// P2G of one element: sums over its points, and their mapping to its nodes.
template <int D, class T>
struct ElementSums {
  T moments[moment_size<D>];
  T momentum[D + 1][D];     ///< Σ m v, Σ m ξ_k v [kg m/s]
  T stress[force_size<D>];  ///< Σ V σ [N m]

  TALUS_KERNEL ElementSums() {
    TALUS_UNROLL
    for (T& m : moments) m = T(0.0);
    TALUS_UNROLL
    for (auto& row : momentum) {
      TALUS_UNROLL
      for (T& p : row) p = T(0.0);
    }
    TALUS_UNROLL
    for (T& s : stress) s = T(0.0);
  }

  TALUS_KERNEL void add(T m, T volume, const T* xi, const T* velocity, const T* sigma) {
    T m_xi[D];
    moments[0] += m;
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      m_xi[k] = m * xi[k];
      moments[1 + k] += m_xi[k];
    }
    int next = 1 + D;
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      TALUS_UNROLL
      for (int j = k; j < D; ++j) moments[next++] += m_xi[k] * xi[j];
    }
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      momentum[0][d] += m * velocity[d];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) momentum[k + 1][d] += m_xi[k] * velocity[d];
    }
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) stress[i] += volume * sigma[force_component<D>(i)];
  }

  /// Mass (2.35), momentum and minus the internal force (2.38) of each node: [node][m, p, -f_int].
  TALUS_KERNEL void to_nodes(const T* g, T out[D + 1][1 + 2 * D]) const {
    T rest = moments[0];
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      out[k + 1][0] = moments[1 + k];
      rest -= moments[1 + k];
    }
    out[0][0] = rest;
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      T p = momentum[0][d];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) {
        out[k + 1][1 + d] = momentum[k + 1][d];
        p -= momentum[k + 1][d];
      }
      out[0][1 + d] = p;
    }
    force_to_nodes(stress, g, out);
  }

  /// Writes -∇N_i·s for a stress sum s into the force columns of `out`.
  TALUS_KERNEL static void force_to_nodes(const T* s, const T* g, T out[D + 1][1 + 2 * D]) {
    T total[D];
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) total[d] = T(0.0);
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      const T* n = g + k * D;
      T f[D];
      if constexpr (D == 2) {
        f[0] = s[0] * n[0] + s[2] * n[1];
        f[1] = s[2] * n[0] + s[1] * n[1];
      } else {
        f[0] = s[0] * n[0] + s[3] * n[1] + s[5] * n[2];
        f[1] = s[3] * n[0] + s[1] * n[1] + s[4] * n[2];
        f[2] = s[5] * n[0] + s[4] * n[1] + s[2] * n[2];
      }
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) {
        out[k + 1][1 + D + d] = -f[d];
        total[d] += f[d];
      }
    }
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) out[0][1 + D + d] = total[d];
  }
};

/// Δt Σ_j M_ij a_j of one element from its moments: the change of nodal momentum in the remap of MUSL (2.41).
template <int D, class T>
TALUS_KERNEL void remap_element(const T* moments, const T a[D + 1][D], double dt, T out[D + 1][D]) {
  TALUS_UNROLL
  for (int d = 0; d < D; ++d) {
    const T first = a[0][d] * dt;
    T slope[D];
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) slope[k] = (a[k + 1][d] - a[0][d]) * dt;
    T total = moments[0] * first;
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) total += moments[1 + k] * slope[k];
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      T s = moments[1 + k] * first;
      TALUS_UNROLL
      for (int j = 0; j < D; ++j) {
        const int low = k < j ? k : j, high = k < j ? j : k;
        s += moments[1 + D + low * D - low * (low - 1) / 2 + (high - low)] * slope[j];
      }
      out[k + 1][d] = s;
      total -= s;
    }
    out[0][d] = total;
  }
}

}  // namespace talus::mpm
