// SPDX-License-Identifier: MIT
#pragma once
// Which elements touch a node, and the rows of a matrix between nodes that share an element. From the mesh alone, in
// the order of its elements: sums over it do not depend on threads.

#include <vector>

#include "mesh/mesh.hpp"

namespace talus::mpm {

template <int D>
struct NodeGraph {
  // Touch t is element `element[t]`, of which the node is local node `local[t]`; those of node i: touch_start[i] …
  std::vector<int> touch_start, element, local;
  std::vector<double> size;            ///< of the elements round a node [m]
  std::vector<int> row_start, column;  ///< entries of row i: row_start[i] … row_end(i); the first is the diagonal
  std::vector<int> place;              ///< [touch][D+1]: the entry of the row that is the column of the element's node

  static constexpr int row_stride = 1;
  int row_end(int i) const { return row_start[i + 1]; }
};

template <int D>
NodeGraph<D> make_node_graph(const mesh::Mesh<D>& mesh);

}  // namespace talus::mpm
