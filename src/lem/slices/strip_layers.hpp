// SPDX-License-Identifier: MIT
#pragma once
// The layers of one strip.

#include <limits>
#include <vector>

#include "lem/slices/strips.hpp"

namespace talus::lem {

struct Edge {
  Point a{}, b{};  ///< from left to right; never vertical
  int region = -1;
  double at(double x) const { return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]); }
};

/// Elevation of the water table where there is none.
inline constexpr double no_water = -std::numeric_limits<double>::infinity();

/// The line of an edge over a strip.
inline StripLine cut_edge(const Edge& edge, double left) {
  const double slope = (edge.b[1] - edge.a[1]) / (edge.b[0] - edge.a[0]);
  return {edge.a[1] + slope * (left - edge.a[0]), slope};
}

/// Stacks the layers of a strip from the ground down to the base, behind those of the strips before. A sliver thinner
/// than `sliver` takes its neighbour's soil.
void stack_layers(Slope::Strips& strips, Strip& strip, const std::vector<Edge>& edges, double sliver);

}  // namespace talus::lem
