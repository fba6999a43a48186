// SPDX-License-Identifier: MIT
#pragma once
// Space-filling order: elements that are near each other in space are near each other in memory.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Sorts the elements by the Morton code of their centroids (equal codes keep their order) and numbers the nodes in
/// the order in which the elements meet them; the named sides follow. Nodes of no element are dropped.
/// The order depends only on the mesh itself. Call it before anything else is derived from the numbers.
template <int D>
void renumber(Mesh<D>& mesh);

}  // namespace talus::mesh
