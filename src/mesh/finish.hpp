// SPDX-License-Identifier: MIT
#pragma once
// Space-filling order: elements that are near each other in space are near each other in memory.

#include <functional>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Sorts the elements by the Morton code of their centroids (equal codes keep their order) and numbers the nodes in
/// the order in which the elements meet them; the named sides follow. Nodes of no element are dropped.
/// The order depends only on the mesh itself. Call it before anything else is derived from the numbers.
template <int D>
void renumber(Mesh<D>& mesh);

// The flattest element sets the time step of the whole calculation, so the flattest ones are worked on.

/// Directions in which a node may move without leaving the corner (none), curve, surface or volume that it lies on.
template <int D>
struct Freedom {
  int count = 0;                                      ///< 0 to D
  std::array<std::array<double, D>, D> directions{};  ///< the first `count` are orthonormal
};

/// Moves nodes of badly shaped elements, one after the other in small steps, each step such that the smallest ratio of
/// altitude to element size around the node grows. Nothing else changes; the outcome does not depend on the machine's
/// number of threads. `get_size` tells the wanted element size [m] at a place.
template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size);

}  // namespace talus::mesh
