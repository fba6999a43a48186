// SPDX-License-Identifier: MIT
#pragma once
// Cuts of a plane mesh along its edges: nodes on a cut are doubled, so that each side has its own.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Edges along which a mesh is cut, by their nodes.
using Cuts = std::vector<std::array<int, 2>>;

/// Elements that receive a node of their own in the place of `node`.
struct DoubledNode {
  int node = 0;
  std::vector<std::size_t> elements;
};

/// Lists the nodes to double. The elements around a node form sectors that the cuts separate; the first sector keeps
/// the node, every other one is an entry. The ends of a cut inside the mesh remain single.
std::vector<DoubledNode> list_doubles(const std::vector<std::array<int, 3>>& elements, const Cuts& cuts);

/// Returns a mesh that is cut: elements keep their numbers, doubles come after the given nodes. Named sides have the
/// nodes of the elements beside them; `name` receives both sides of all cuts. Throws Error (wrong_input) if a cut
/// consists of one edge inside the mesh, which has no node to double.
Mesh<2> split(Mesh<2> mesh, const Cuts& cuts, const std::string& name);

}  // namespace talus::mesh
