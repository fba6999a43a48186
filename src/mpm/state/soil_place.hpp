// SPDX-License-Identifier: MIT
#pragma once
// Places in the soil on which bars act: the nodes with which they move, and the material points that they follow
// (theory 25).

#include <vector>

#include "base/vec.hpp"

namespace talus::mpm {

template <int D>
struct Body;

/// Weight of a node of the mesh in the motion of a place.
struct NodeShare {
  int node = -1;
  double weight = 0;
};

/// Weight of a material point in a place.
struct PointShare {
  int point = -1;
  double weight = 0;
};

/// A place in the soil. Its motion is the weighted mean of that of nodes, and the force on it acts on them with the
/// same weights, whose sum is 1.
struct SoilPlace {
  Vec<2> x{};        ///< [m]
  int element = -1;  ///< holds the place, or is where it has left the grid; -1: none
  Vec<2> xi{};
  bool is_joined = false;           ///< there is soil at the place
  std::vector<NodeShare> shares;    ///< in the present step; empty if it is not joined
  std::vector<PointShare> carried;  ///< by these points; of places that move with the same soil throughout
};

/// Mass of the soil at a node [kg].
double sum_node_mass(const Body<2>& body, int node);

/// Joins a place through which soil may slip to the soil around it at present, by shape functions (T25.1) or, at the
/// edge of the soil, to the points next to it (T25.2). In elements that are not full it is joined if the nearest point
/// is not farther than its own size.
void join_place(const Body<2>& body, SoilPlace& place);

/// Joins a place on the ground to the points that carry it, which the first call selects by (T25.2).
void join_to_points(const Body<2>& body, SoilPlace& place);

/// Velocity of a joined place [m/s].
Vec<2> move_place(const Body<2>& body, const SoilPlace& place);

}  // namespace talus::mpm
