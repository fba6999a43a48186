// SPDX-License-Identifier: MIT
#pragma once
// fade_unseen() thread by thread.

#include "mpm/device/device_kernels.hpp"
#include "mpm/step/fade_lines.hpp"

namespace talus::mpm::device {

/// What the iteration for the nodes' velocities works on.
template <int D>
struct FadeRows {
  View<double> u;          ///< [node][fade_stride] velocities [m/s]
  View<double> direction;  ///< [node][D] last change of u
  View<double> product;    ///< [element][D+1][D] what an element adds to M u
};

/// Momentum and mass of a node, over its elements.
template <int D>
TALUS_PORTABLE void sum_momentum(const ThreadBody<D>& body, int i, double* t) {
  const int first = body.layout->row_start[i], count = body.layout->row_start[i + 1] - first;
  for (int q = 0; q <= D; ++q) t[q] = 0;
  if (count > 0) sum_rows<1 + D, sums_stride>(body.nodes.sums, &body.layout->node_rows[first], count, t);
}

template <int D>
struct StartFading {
  ThreadBody<D> body;
  FadeRows<D> rows;

  TALUS_PORTABLE void operator()(int i) const {
    double t[1 + D];
    sum_momentum(body, i, t);
    const double inverse = t[0] > 1e-12 * body.smallest_mass ? 1 / t[0] : 0;
    for (int d = 0; d < D; ++d) {
      rows.u[static_cast<std::size_t>(i) * fade_stride + static_cast<std::size_t>(d)] = t[1 + d] * inverse;
      rows.direction[static_cast<std::size_t>(i) * D + static_cast<std::size_t>(d)] = 0;
    }
  }
};

template <int D>
struct MultiplyMass {
  ThreadBody<D> body;
  FadeRows<D> rows;

  TALUS_PORTABLE void operator()(int e) const {
    const ThreadBody<D> mine = body.for_element(e);
    double value[D + 1][D], out[D + 1][D] = {};
    if (count_slots(mine.points, e / device_width) > 0)
      multiply_mass(mine, mine.elements.moments, rows.u, e / device_width, value, out);
    double* product = &rows.product[static_cast<std::size_t>(e) * (D + 1) * D];
    for (int k = 0; k <= D; ++k)
      for (int d = 0; d < D; ++d) product[k * D + d] = out[k][d];
  }
};

template <int D>
struct ImproveVelocity {
  ThreadBody<D> body;
  FadeRows<D> rows;
  FadeWeights weights;

  TALUS_PORTABLE void operator()(int i) const {
    double t[1 + D], Mu[D] = {};
    sum_momentum(body, i, t);
    const double inverse = t[0] > 1e-12 * body.smallest_mass ? 1 / t[0] : 0;
    for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1]; ++r) {
      const double* product = &rows.product[static_cast<std::size_t>(body.layout->node_rows[r]) * D];
      for (int d = 0; d < D; ++d) Mu[d] += product[d];
    }
    double* u = &rows.u[static_cast<std::size_t>(i) * fade_stride];
    double* direction = &rows.direction[static_cast<std::size_t>(i) * D];
    for (int d = 0; d < D; ++d) {
      direction[d] = weights.keep * direction[d] + weights.step * (t[1 + d] - Mu[d]) * inverse;
      u[d] += direction[d];
    }
  }
};

/// Puts the points of an element onto the nodes' velocities. `accounts`: what they lose, as `shared`.
template <int D>
struct FadeElement {
  ThreadBody<D> body;
  FadeRows<D> rows;
  int more_mass;  ///< field of mass that moves with the points; -1: none
  View<ElementAccount> accounts;

  TALUS_PORTABLE void operator()(int e) const {
    ThreadBody<D> mine = body.for_element(e);
    const int b = e / device_width;
    double value[D + 1][D], out[D + 1][D], lost = 0;
    if (count_slots(mine.points, b) > 0) {
      multiply_mass(mine, mine.elements.moments, rows.u, b, value, out);
      for (int k = 0; k <= D; ++k)
        for (int d = 0; d < D; ++d) sums_row(mine, e, k)[1 + d] = out[k][d];
      fade_points(mine, b, value, {PointFields<D>::mass, PointFields<D>::velocity, more_mass}, lost);
    }
    accounts[static_cast<std::size_t>(e)] = {0, lost};
  }
};

}  // namespace talus::mpm::device
