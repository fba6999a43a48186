// SPDX-License-Identifier: MIT
#pragma once
// Which element lies across which side.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// For every element the elements across the sides opposite its local nodes, -1 where the mesh ends.
/// Sides are sorted by their lowest node and matched within each short list: linear in the number of elements.
/// Throws Error (wrong_input) when more than two elements share a side, which means that elements overlap.
template <int D>
std::vector<typename Mesh<D>::Element> find_neighbours(const Mesh<D>& mesh);

}  // namespace talus::mesh
