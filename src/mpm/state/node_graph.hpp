// SPDX-License-Identifier: MIT
#pragma once
// Graph of the mesh for the pressure equation: the elements around each node, and the matrix rows of nodes that share
// an element. It follows from the mesh alone, in the order of its elements, so sums over it do not depend on threads.

#include <vector>

#include "mesh/mesh.hpp"

namespace talus::mpm {

template <int D>
struct NodeGraph {
  // Touch t is element `element[t]`, in which the node is local node `local[t]`; the touches of node i start at
  // touch_start[i].
  std::vector<int> touch_start, element, local;
  std::vector<double> size;            ///< h_i, size of the elements around a node (T22.7) [m]
  std::vector<int> row_start, column;  ///< entries of row i: row_start[i] … row_end(i); the first is the diagonal
  std::vector<int> place;              ///< [touch][D+1]: entry of the row whose column is that node of the element

  static constexpr int row_stride = 1;
  int row_end(int i) const { return row_start[i + 1]; }
};

template <int D>
NodeGraph<D> make_node_graph(const mesh::Mesh<D>& mesh);

}  // namespace talus::mpm
