// SPDX-License-Identifier: MIT
// Middles of the edges, and what supports leave free.

#include "bounds/velocities.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bounds {

Velocities number_velocities(const Problem& problem) {
  Velocities v;
  v.nodes = problem.nodes;
  v.triangles.resize(problem.size());
  const std::vector<Edge> edges = list_edges(problem.triangles);
  auto& middles = v.middles;
  for (const Edge& edge : edges) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    middles[make_key(edge.from, edge.to)] = static_cast<int>(v.nodes.size());
    v.nodes.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
  }
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = problem.triangles[e][i], b = problem.triangles[e][(i + 1) % 3];
      v.triangles[e][i] = a;
      v.triangles[e][3 + i] = middles.at(make_key(a, b));
    }
  // Directions that are held, at most two that differ.
  std::vector<std::vector<Vec<2>>> held(v.nodes.size());
  auto hold = [&](int node, const Vec<2>& direction) {
    auto& own = held[static_cast<std::size_t>(node)];
    const bool known = std::any_of(own.begin(), own.end(), [&](const Vec<2>& h) {
      return std::abs(h[0] * direction[1] - h[1] * direction[0]) < 1e-9;
    });
    if (!known) own.push_back(direction);
  };
  for (const Side& side : problem.sides) {
    const Vec<2>&from = problem.nodes[static_cast<std::size_t>(side.from)],
          &to = problem.nodes[static_cast<std::size_t>(side.to)];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Vec<2> along{(to[0] - from[0]) / length, (to[1] - from[1]) / length}, normal{along[1], -along[0]};
    for (const int node : {side.from, side.to, middles.at(make_key(side.from, side.to))}) {
      if (side.holds_normal) hold(node, normal);
      if (side.holds_along) hold(node, along);
    }
  }
  v.freedoms.resize(v.nodes.size());
  for (std::size_t n = 0; n < v.nodes.size(); ++n) {
    if (held[n].empty()) {
      v.freedoms[n] = {{{1, 0}, v.count}, {{0, 1}, v.count + 1}};
      v.count += 2;
    } else if (held[n].size() == 1) {
      v.freedoms[n] = {{{-held[n][0][1], held[n][0][0]}, v.count++}};
    }
  }
  return v;
}

}  // namespace talus::bounds
