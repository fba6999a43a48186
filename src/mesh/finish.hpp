// SPDX-License-Identifier: MIT
#pragma once
// Renumbering of a mesh along a space-filling curve, for memory locality, and improvement of flat elements.

#include <functional>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Sorts the elements by the Morton code of their centroids (equal codes keep their order) and numbers the nodes in the
/// order of first use; the named sides are renumbered accordingly. Unused nodes are removed. The order depends on the
/// mesh only. Call this function before other data are derived from the numbers.
template <int D>
void renumber(Mesh<D>& mesh);

// The smallest altitude limits the time step of the whole calculation, so the flattest elements are improved.

/// Directions in which a node may move within its corner (none), curve, surface or volume.
template <int D>
struct Freedom {
  int count = 0;                                      ///< 0 to D
  std::array<std::array<double, D>, D> directions{};  ///< the first `count` are orthonormal
};

/// Moves nodes of badly shaped elements one after the other in small steps, each of which increases the smallest ratio
/// of altitude to element size around the node. Nothing else changes, and the result does not depend on the number of
/// threads. `get_size` returns the target element size [m] at a point.
template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size);

}  // namespace talus::mesh
