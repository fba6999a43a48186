// SPDX-License-Identifier: MIT
#pragma once
// Bisection of triangles into nested conforming meshes (Rivara, Int. J. Numer. Meth. Eng. 20, 1984).

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// An edge by its two nodes, the smaller number first.
using EdgeKey = std::pair<int, int>;
inline EdgeKey make_edge_key(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Triangles after bisection. The given nodes keep their numbers.
struct Bisection {
  std::vector<std::array<double, 2>> nodes;                   ///< [m]
  std::map<EdgeKey, int> middles;                             ///< of each bisected edge: the node at its middle
  std::vector<std::array<int, 3>> triangles;                  ///< oriented as their parents, in the order of these
  std::vector<std::size_t> parent;                            ///< per triangle, the given one that contains it
  std::vector<std::array<std::array<double, 3>, 3>> weights;  ///< per corner: its barycentric coordinates in the parent
};

/// Bisects marked edges of triangles. The arguments of the constructor must outlive the object.
class Bisector {
 public:
  Bisector(const std::vector<std::array<double, 2>>& nodes, const std::vector<std::array<int, 3>>& triangles)
      : triangles_(triangles) {
    to_.nodes = nodes;
  }

  void mark(const EdgeKey& edge) { to_.middles[edge] = -1; }
  bool has_marked() const { return !to_.middles.empty(); }

  /// Returns the longest edge; of equal ones that with the smallest node numbers, so that both triangles of an edge
  /// choose alike.
  EdgeKey find_longest(const std::array<int, 3>& triangle) const;

  /// `keeps_shape`: a triangle with a bisected edge has its longest edge bisected too, so that no angle falls below
  /// half of the smallest given one. Call once.
  Bisection run(bool keeps_shape);

 private:
  using Weights = std::array<std::array<double, 3>, 3>;

  const std::array<double, 2>& get(int node) const { return to_.nodes[static_cast<std::size_t>(node)]; }
  /// Bisects the longest of the marked edges, recursively.
  void split(const std::array<int, 3>& t, const Weights& w, std::size_t parent);

  const std::vector<std::array<int, 3>>& triangles_;
  Bisection to_;
};

/// Divides each marked element into four of half its size, by bisection of its longest edge and then of the other two,
/// and neighbours as conformity requires. Regions and named sides are kept, those inside the section too. The mesh is
/// finished, with new numbers.
Mesh<2> refine(const Mesh<2>& mesh, const std::vector<bool>& marked);

}  // namespace talus::mesh
