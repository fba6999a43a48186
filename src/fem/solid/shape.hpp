// SPDX-License-Identifier: MIT
#pragma once
// Quadratic shape functions of straight-sided triangles and tetrahedra, and their integration points. Internal to fem/.

#include <array>
#include <cstddef>

#include "base/vec.hpp"

namespace talus::fem {

/// Constants of a quadratic simplex. Local nodes: the D+1 corners, then the middles of the edges in the order of
/// `edges`.
template <int D>
struct Quadratic;

template <>
struct Quadratic<2> {
  static constexpr std::size_t corners = 3, nodes = 6, points = 3, strains = 4;
  static constexpr std::array<std::array<std::size_t, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}};
  static constexpr double near = 2.0 / 3, far = 1.0 / 6;  ///< of integration points, barycentric; equal weights
};
template <>
struct Quadratic<3> {
  static constexpr std::size_t corners = 4, nodes = 10, points = 4, strains = 6;
  static constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  static constexpr double near = 0.58541019662496845446, far = 0.13819660112501051518;
};

/// Returns the barycentric coordinates of integration point q.
template <int D>
constexpr std::array<double, D + 1> find_barycentric(std::size_t q) {
  std::array<double, D + 1> l{};
  l.fill(Quadratic<D>::far);
  l[q] = Quadratic<D>::near;
  return l;
}

/// Returns ∇N of all nodes [1/m] at the barycentric coordinates `l` with gradients `g`.
template <int D>
std::array<Vec<D>, Quadratic<D>::nodes> find_gradients(const std::array<double, D + 1>& l,
                                                       const std::array<Vec<D>, D + 1>& g) {
  using Q = Quadratic<D>;
  std::array<Vec<D>, Q::nodes> r;
  for (std::size_t d = 0; d < D; ++d) {
    for (std::size_t i = 0; i < Q::corners; ++i) r[i][d] = (4 * l[i] - 1) * g[i][d];
    for (std::size_t k = 0; k < Q::edges.size(); ++k) {
      const auto [a, b] = Q::edges[k];
      r[Q::corners + k][d] = 4 * (l[a] * g[b][d] + l[b] * g[a][d]);
    }
  }
  return r;
}

/// Computes the gradients of the barycentric coordinates of a simplex; returns its volume (negative: inverted).
template <int D>
double find_simplex(const std::array<Vec<D>, D + 1>& x, std::array<Vec<D>, D + 1>& g) {
  double volume;
  if constexpr (D == 2) {
    const double ax = x[1][0] - x[0][0], ay = x[1][1] - x[0][1], bx = x[2][0] - x[0][0], by = x[2][1] - x[0][1];
    const double det = ax * by - ay * bx;
    volume = det / 2;
    g[1] = {by / det, -bx / det};
    g[2] = {-ay / det, ax / det};
  } else {
    Vec<3> a[3];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) a[k][d] = x[k + 1][d] - x[0][d];
    const auto cross = [](const Vec<3>& p, const Vec<3>& q) {
      return Vec<3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    };
    const double det = dot(a[0], cross(a[1], a[2]));
    volume = det / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      g[k + 1] = cross(a[(k + 1) % 3], a[(k + 2) % 3]);
      for (double& v : g[k + 1]) v /= det;
    }
  }
  for (std::size_t d = 0; d < D; ++d) {
    g[0][d] = 0;
    for (std::size_t k = 1; k <= D; ++k) g[0][d] -= g[k][d];
  }
  return volume;
}

}  // namespace talus::fem
