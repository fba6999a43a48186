// SPDX-License-Identifier: MIT
#pragma once
// What elements give to a nodal average and take from it. `first`: the first lane of a block.

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Elements with a point that keeps a gap.
template <class B, class T = typename B::Lanes>
TALUS_KERNEL MaskOf<T> is_apart(const B& body, std::size_t first) {
  return load<T>(&body.elements.apart[first]) > T(0.0);
}

/// Elements that take part in nodal averages: they hold points, and none of these keeps a gap. Soil that has come apart
/// hands no volume change on, and averaging over it would make energy (theory 4).
template <class B, class T = typename B::Lanes>
TALUS_KERNEL MaskOf<T> takes_part(const B& body, std::size_t first) {
  return load<T>(&body.points.count[first]) > T(0.0) && !is_apart(body, first);
}

/// Share of what averaging takes that an element keeps for one step, as a viscosity of what no node feels (T4.5).
inline constexpr double kept_share = 0.25;

/// The volumetric strain increment of the elements of a block under stable smoothing, from their `own` and the nodal
/// `average` of what is elastic of it (T4.4, T4.5). `rough`: what averaging took, for the next step.
template <class B, class T = typename B::Lanes>
TALUS_KERNEL T join_dilation(const B& body, std::size_t first, T own, T average, T& rough) {
  const T plastic = load<T>(&body.elements.plastic_dilation[first]);
  rough = select(takes_part(body, first), own - plastic - average, T(0.0));
  return average + plastic + kept_share * (rough - load<T>(&body.elements.rough[first]));
}

/// Mean over the nodes of the elements of a body of a column of rows that are Stride doubles long.
template <class B, int Stride>
TALUS_KERNEL typename B::Lanes find_node_mean(const double* column, const int* rows) {
  constexpr int D = B::dimension;
  typename B::Lanes mean(0.0);
  for (int l = 0; l < LaneTraits<typename B::Lanes>::width; ++l) {
    double s = 0;
    for (int k = 0; k <= D; ++k) s += column[static_cast<std::int64_t>(rows[k * B::width + l]) * Stride];
    set_lane(mean, l, s / (D + 1));
  }
  return mean;
}

}  // namespace talus::mpm
