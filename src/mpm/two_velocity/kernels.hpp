// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the pore water of one element: motion (G2P) and sums (P2G), the counterpart of
// mpm/kernels/point_kernels.hpp. They are templates on T.

#include "mpm/kernels/point_kernels.hpp"

namespace talus::mpm {

/// Columns of a node's row of sums. The first ones are those of one phase, with the mass of the grains.
template <int D>
struct WetColumns {
  static constexpr int mass = 0;                    ///< M_s [kg]
  static constexpr int momentum = 1;                ///< of the grains [kg m/s]
  static constexpr int force = 1 + D;               ///< -Σ V̄ (σ' + χp I) ∇N [N]
  static constexpr int water_mass = 1 + 2 * D;      ///< M̄_w [kg]
  static constexpr int water_momentum = 2 + 2 * D;  ///< [kg m/s]
  static constexpr int water_force = 2 + 3 * D;     ///< -Σ V̄ p ∇N [N]
  static constexpr int volume = 2 + 4 * D;          ///< Σ N V of wet points, M_w/ρ_w [m³]
  static constexpr int resistance = 3 + 4 * D;      ///< Σ N V ρ_w g/k_sat [kg/s]
  static constexpr int relative = 4 + 4 * D;        ///< Σ N V k_r [m³]
  static constexpr int outside = 5 + 4 * D;         ///< Σ V̄ ∇N of wet points [m²]
  static constexpr int outside_scale = 5 + 5 * D;   ///< Σ V̄ (|∂N/∂x| + |∂N/∂y| + ...) [m²]
  static constexpr int count = 6 + 5 * D;
};

/// Motion of the water of an element in one step, affine in the local coordinates.
template <int D, class T>
struct WaterMotion {
  T dw_first[D], dw_slope[D][D];  ///< Δt a_w [m/s]
  T divergence;                   ///< Δt div θ(w-v) [-]

  TALUS_KERNEL WaterMotion(const T a[D + 1][D], const T flux[D + 1][D], const T* g, double dt) {
    divergence = T(0.0);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      dw_first[d] = a[0][d] * dt;
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) {
        dw_slope[k][d] = (a[k + 1][d] - a[0][d]) * dt;
        divergence += (flux[k + 1][d] - flux[0][d]) * g[k * D + d];
      }
    }
    divergence = divergence * dt;
  }

  TALUS_KERNEL void advance_velocity(const T* xi, T* w) const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      T s = w[d] + dw_first[d];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) s += dw_slope[k][d] * xi[k];
      w[d] = s;
    }
  }
};

/// Quantities of a point in the sums of the water; a dry point has V = m = 0.
template <class T>
struct WaterPoint {
  T mass, volume, pressure, bishop, saturation;
  T resistance;  ///< ρ_w g/k_sat [N s/m⁴]
  T relative;    ///< k_r [-]
};

/// Sums over the wet points of an element.
template <int D, class T>
struct WaterSums {
  T moments[moment_size<D>];  ///< of the water's mass
  T momentum[D + 1][D];       ///< Σ m_w w, Σ m_w ξ_k w [kg m/s]
  T volume[D + 1];            ///< Σ V, Σ V ξ_k [m³]
  T resistance[D + 1];        ///< Σ V ρ_w g/k_sat, Σ V ξ_k ρ_w g/k_sat [kg/s]
  T relative[D + 1];          ///< Σ V k_r, Σ V ξ_k k_r [m³]
  T pressure, bishop;         ///< Σ V p, Σ V χp [N m]
  T saturation;               ///< Σ V S [m³]

  TALUS_KERNEL WaterSums() {
    TALUS_UNROLL
    for (T& m : moments) m = T(0.0);
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      volume[k] = resistance[k] = relative[k] = T(0.0);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) momentum[k][d] = T(0.0);
    }
    pressure = bishop = saturation = T(0.0);
  }

  TALUS_KERNEL void add(const WaterPoint<T>& point, const T* xi, const T* w) {
    T m_xi[D];
    const T m = point.mass, V = point.volume, r = V * point.resistance, k_r = V * point.relative;
    moments[0] += m;
    volume[0] += V;
    resistance[0] += r;
    relative[0] += k_r;
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      m_xi[k] = m * xi[k];
      moments[1 + k] += m_xi[k];
      volume[1 + k] += V * xi[k];
      resistance[1 + k] += r * xi[k];
      relative[1 + k] += k_r * xi[k];
    }
    int next = 1 + D;
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      TALUS_UNROLL
      for (int j = k; j < D; ++j) moments[next++] += m_xi[k] * xi[j];
    }
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      momentum[0][d] += m * w[d];
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) momentum[k + 1][d] += m_xi[k] * w[d];
    }
    pressure += V * point.pressure;
    bishop += V * point.bishop;
    saturation += V * point.saturation;
  }

  /// P2G: adds the water's columns to the row of each node. `stretch` is V̄/V.
  TALUS_KERNEL void to_nodes(const T* g, T stretch, T out[D + 1][WetColumns<D>::count]) const {
    using C = WetColumns<D>;
    spread(moments, C::water_mass, out);
    spread(volume, C::volume, out);
    spread(resistance, C::resistance, out);
    spread(relative, C::relative, out);
    const T force = pressure * stretch, integrated = volume[0] * stretch;
    T rest[D];  // -∇N_0
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      T p = momentum[0][d];
      rest[d] = T(0.0);
      TALUS_UNROLL
      for (int k = 0; k < D; ++k) {
        out[k + 1][C::water_momentum + d] = momentum[k + 1][d];
        p -= momentum[k + 1][d];
        rest[d] += g[k * D + d];
      }
      out[0][C::water_momentum + d] = p;
      out[0][C::water_force + d] = force * rest[d];
      out[0][C::outside + d] = -(integrated * rest[d]);
    }
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      T norm(0.0);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) {
        const T gradient = k == 0 ? rest[d] : g[(k == 0 ? 0 : k - 1) * D + d];
        norm += lane_abs(gradient);
        if (k == 0) continue;
        out[k][C::water_force + d] = -(force * gradient);
        out[k][C::outside + d] = integrated * gradient;
      }
      out[k][C::outside_scale] = integrated * norm;
    }
  }

 private:
  /// Writes Σ_p q_p N_i of a quantity with the moments m[0] and m[1 + k] to the nodes.
  TALUS_KERNEL static void spread(const T* m, int column, T out[D + 1][WetColumns<D>::count]) {
    T rest = m[0];
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      out[k + 1][column] = m[1 + k];
      rest -= m[1 + k];
    }
    out[0][column] = rest;
  }
};

/// Copies the columns of the grains from the sums of one phase.
template <int D, class T>
TALUS_KERNEL void copy_solid_columns(const T solid[D + 1][1 + 2 * D], T out[D + 1][WetColumns<D>::count]) {
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) {
    TALUS_UNROLL
    for (int c = 0; c < 1 + 2 * D; ++c) out[k][c] = solid[k][c];
  }
}

}  // namespace talus::mpm
