// SPDX-License-Identifier: MIT
#pragma once
// Kernels of filter_null_modes(), the filter of null modes, for a body B of packs or of one GPU thread.

#include <array>

#include "base/rows.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Weights of Chebyshev's iteration for M_l⁻¹ M u = M_l⁻¹ p with the lumped mass matrix M_l; the eigenvalues are
/// between 0 and 1. The weights are constants, so the result is linear in p and needs no sums over the body. Modes with
/// eigenvalues below `smallest` are almost null modes and are filtered in part.
struct FilterWeights {
  double keep;  ///< factor on the last change of u
  double step;  ///< factor on the residual of the momentum
};
inline std::array<FilterWeights, 8> list_filter_weights() {
  constexpr double smallest = 0.1, middle = (1 + smallest) / 2, half_width = (1 - smallest) / 2;
  double rho = half_width / middle;
  std::array<FilterWeights, 8> weights{};
  weights[0] = {0, 1 / middle};
  for (std::size_t n = 1; n < weights.size(); ++n) {
    const double next = 1 / (2 * middle / half_width - rho);
    weights[n] = {next * rho, 2 * next / half_width};
    rho = next;
  }
  return weights;
}

/// Number of doubles in a node row of velocities.
inline constexpr int filter_stride = 8;

/// Σ_j M_ij u_j of the elements of block `b`. `value` receives the u of their nodes from `rows`.
template <class B, class Moments, class Rows, int D = B::dimension, class T = typename B::Lanes>
TALUS_KERNEL void multiply_mass(const B& body, const Moments& moments, const Rows& rows, int b, T (&value)[D + 1][D],
                                T (&out)[D + 1][D]) {
  constexpr int width = B::width;
  const int* at = &body.layout->connectivity[static_cast<std::size_t>(b) * width * (D + 1)];
  T m[moment_size<D>];
  for (int k = 0; k <= D; ++k) load_rows<D, filter_stride>(rows.data(), at + k * width, value[k]);
  for (int q = 0; q < moment_size<D>; ++q)
    m[q] = load<T>(&moments[(static_cast<std::size_t>(b) * moment_size<D> + static_cast<std::size_t>(q)) * width]);
  remap_element<D, T>(m, value, 1, out);
}

/// Field indices in a slot.
struct FilteredFields {
  int mass, velocity;
  int more_mass = -1;  ///< mass that moves with the phase; -1: none
};

/// G2P: replaces the velocities of the points of block `b` by those interpolated from `value` at their nodes. Adds the
/// kinetic energy that they lose to `kinetic` [J].
template <class B, int D = B::dimension, class T = typename B::Lanes>
TALUS_KERNEL void filter_points(B& body, int b, const T (&value)[D + 1][D], const FilteredFields& fields, T& kinetic) {
  constexpr int width = B::width;
  const T count = load<T>(&body.points.count[static_cast<std::size_t>(b) * width]);
  for (int k = 0; k < count_slots(body.points, b); ++k) {
    double* p = body.points.slot(body.points.block_start[b] + k);
    const MaskOf<T> active = count > T(static_cast<double>(k));
    T mass = load<T>(p + fields.mass * width);
    if (fields.more_mass >= 0) mass += load<T>(p + fields.more_mass * width);
    for (int d = 0; d < D; ++d) {
      double* velocity = p + (fields.velocity + d) * width;
      const T before = load<T>(velocity);
      T after = value[0][d];
      for (int n = 0; n < D; ++n)
        after += load<T>(p + (PointFields<D>::xi + n) * width) * (value[n + 1][d] - value[0][d]);
      kinetic += select(active, 0.5 * mass * (before * before - after * after), T(0.0));
      store(velocity, select(active, after, before));
    }
  }
}

}  // namespace talus::mpm
