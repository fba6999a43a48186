// SPDX-License-Identifier: MIT
// Elements around each node, and the rows of the matrix of nodal pressures.
#include "mpm/state/darcy_water.hpp"

#include <algorithm>
#include <cmath>

namespace talus::mpm {

template <int D>
NodeGraph<D> make_node_graph(const mesh::Mesh<D>& mesh) {
  NodeGraph<D> graph;
  const std::size_t nodes = mesh.nodes.size();
  graph.touch_start.assign(nodes + 1, 0);
  for (const auto& element : mesh.elements)
    for (int node : element) ++graph.touch_start[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i < nodes; ++i) graph.touch_start[i + 1] += graph.touch_start[i];
  graph.element.resize(static_cast<std::size_t>(graph.touch_start.back()));
  graph.local.resize(graph.element.size());
  std::vector<int> next(graph.touch_start.begin(), graph.touch_start.end() - 1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const auto t = static_cast<std::size_t>(next[mesh.elements[e][k]]++);
      graph.element[t] = e;
      graph.local[t] = k;
    }
  constexpr double simplices = D == 2 ? 2 : 6;  // in a square, in a cube
  for (std::size_t i = 0; i < nodes; ++i) {
    double volume = 0;
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) volume += mesh.volumes[graph.element[t]];
    graph.size.push_back(std::pow(simplices * volume / (graph.touch_start[i + 1] - graph.touch_start[i]), 1.0 / D));
  }
  graph.place.resize(graph.element.size() * (D + 1));
  std::vector<int> rows[lane_width];
  for (std::size_t first = 0; first < nodes; first += lane_width) {
    const auto begin = static_cast<int>(graph.column.size());
    const std::size_t count = std::min(nodes - first, static_cast<std::size_t>(lane_width));
    std::size_t longest = 0;
    for (std::size_t l = 0; l < count; ++l) {
      const std::size_t i = first + l;
      std::vector<int>& row = rows[l];
      row.assign(1, static_cast<int>(i));
      for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t)
        for (int k = 0; k <= D; ++k) {
          const int node = mesh.elements[graph.element[t]][k];
          const auto at = std::find(row.begin(), row.end(), node);
          graph.place[static_cast<std::size_t>(t) * (D + 1) + static_cast<std::size_t>(k)] =
              begin + static_cast<int>(l) + static_cast<int>(at - row.begin()) * lane_width;
          if (at == row.end()) row.push_back(node);
        }
      longest = std::max(longest, row.size());
      graph.row_start.push_back(begin + static_cast<int>(l));
      graph.row_ends.push_back(graph.row_start.back() + static_cast<int>(row.size()) * lane_width);
    }
    for (std::size_t k = 0; k < longest; ++k)
      for (std::size_t l = 0; l < lane_width; ++l)
        graph.column.push_back(l < count && k < rows[l].size() ? rows[l][k]
                                                               : static_cast<int>(std::min(first + l, nodes - 1)));
  }
  graph.row_start.push_back(static_cast<int>(graph.column.size()));
  return graph;
}

template NodeGraph<2> make_node_graph<2>(const mesh::Mesh<2>&);
template NodeGraph<3> make_node_graph<3>(const mesh::Mesh<3>&);

}  // namespace talus::mpm
