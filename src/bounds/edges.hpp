// SPDX-License-Identifier: MIT
#pragma once
// Edges of a triangulation, with the triangles on both sides.

#include <algorithm>
#include <map>
#include <vector>

#include "bounds/problem.hpp"

namespace talus::bounds {

/// An edge by its corners, the smaller number first.
using EdgeKey = std::pair<int, int>;
inline EdgeKey make_key(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

struct Edge {
  int from = 0, to = 0;        ///< counterclockwise of `triangle`
  int triangle = 0, side = 0;  ///< its side from corner `side` to the next
  int other = -1;              ///< triangle on the other side; -1: the border
};

/// In the order in which the triangles meet them.
inline std::vector<Edge> list_edges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  std::map<EdgeKey, std::size_t> known;
  for (std::size_t e = 0; e < triangles.size(); ++e)
    for (int i = 0; i < 3; ++i) {
      const int a = triangles[e][static_cast<std::size_t>(i)], b = triangles[e][static_cast<std::size_t>((i + 1) % 3)];
      const auto [at, is_new] = known.try_emplace(make_key(a, b), edges.size());
      if (is_new) {
        edges.push_back({a, b, static_cast<int>(e), i, -1});
      } else {
        edges[at->second].other = static_cast<int>(e);
      }
    }
  return edges;
}

/// Number of a node among the corners of a triangle.
inline std::size_t find_corner(const Triangle& triangle, int node) {
  return triangle[0] == node ? 0 : triangle[1] == node ? 1 : 2;
}

}  // namespace talus::bounds
