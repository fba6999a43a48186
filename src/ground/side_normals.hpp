// SPDX-License-Identifier: MIT
#pragma once
// Named sides and lines of a mesh: the elements beside them, their normals, and those of their nodes.

#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mpm/body/body.hpp"

namespace talus::ground {

/// Throws Error (wrong_input) for a side that the mesh does not have, with the names it has.
template <int D>
const std::vector<typename mesh::Mesh<D>::Side>& find_sides(const mesh::Mesh<D>& mesh, const std::string& name);

/// Elements at a side: those that contain all its nodes, with the local node that lies opposite.
struct SideElement {
  int element, opposite;
};

/// By the side's nodes in increasing order.
template <int D>
using SideMap = std::map<std::array<int, D>, std::vector<SideElement>>;

template <int D>
SideMap<D> map_sides(const mesh::Mesh<D>& mesh, const std::vector<typename mesh::Mesh<D>::Side>& wanted);

/// Unit normal of the element's side opposite local node k, out of the element; and the side's area [m, m²].
template <int D>
std::pair<Vec<D>, double> find_outward_normal(const mesh::Mesh<D>& mesh, int e, int k);

/// Normal of a wall, out of the soil: away from the element that holds soil, or else along gravity.
template <int D>
Vec<D> find_wall_normal(const mpm::Body<D>& body, const std::vector<SideElement>& elements,
                        const std::type_identity_t<Vec<D>>& gravity);

/// Normals at each node of the named sides, those of one smooth line averaged.
template <int D>
std::map<int, std::vector<Vec<D>>> find_node_normals(const mpm::Body<D>& body,
                                                     const std::vector<typename mesh::Mesh<D>::Side>& sides,
                                                     const std::type_identity_t<Vec<D>>& gravity);

/// Adds a direction to those that are fixed (`count` of them, orthonormal); nothing when it lies among them already.
template <int D>
void add_direction(Vec<D> (&fixed)[D], int& count, std::type_identity_t<Vec<D>> direction);

}  // namespace talus::ground
