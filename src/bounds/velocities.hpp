// SPDX-License-Identifier: MIT
#pragma once
// The velocities of the upper bound: nodes of quadratic triangles, and the directions in which each may move.

#include <map>
#include <vector>

#include "bounds/edges.hpp"

namespace talus::bounds {

struct Velocities {
  std::vector<Vec<2>> nodes;                  ///< corners, then middles of edges
  std::vector<std::array<int, 6>> triangles;  ///< corners, then the middles after them (0–1, 1–2, 2–0)
  /// Of each node the directions in which it may move, with their numbers; none where it is held. The nodes of a rigid
  /// body share its translations and its rotation.
  struct Freedom {
    Vec<2> direction;
    int number;
  };
  std::vector<std::vector<Freedom>> freedoms;
  std::map<EdgeKey, int> middles;  ///< of the edges
  int count = 0;
};

/// Every velocity that supports leave free has a number. Touching rigid triangles (is_rigid()) are one body; one that
/// is held in one direction alone moves across it without turning, and one that is held otherwise does not move.
Velocities number_velocities(const Problem& problem, const Units& units);

}  // namespace talus::bounds
