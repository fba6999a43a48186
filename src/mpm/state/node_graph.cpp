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
  graph.lanes = (mesh.elements.size() + lane_width - 1) / lane_width * lane_width;
  std::vector<std::vector<int>> touches(nodes);  // e (D + 1) + local
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) touches[mesh.elements[e][k]].push_back(e * (D + 1) + k);
  constexpr double simplices = D == 2 ? 2 : 6;  // in a square, in a cube
  for (std::size_t first = 0; first < nodes; first += lane_width) {
    const auto begin = static_cast<int>(graph.element.size());
    std::size_t longest = 0;
    for (std::size_t i = first; i < first + lane_width; ++i)
      if (i < nodes) longest = std::max(longest, touches[i].size());
    for (std::size_t k = 0; k < longest; ++k)
      for (std::size_t l = 0; l < lane_width; ++l) {
        const std::vector<int>* of_node = first + l < nodes ? &touches[first + l] : nullptr;
        const bool is_gap = of_node == nullptr || k >= of_node->size();
        const int touch = !is_gap ? (*of_node)[k] : of_node != nullptr && !of_node->empty() ? of_node->front() : 0;
        graph.element.push_back(touch / (D + 1));
        graph.local.push_back(touch % (D + 1));
        graph.corner.push_back(static_cast<int>(graph.find_corner(graph.element.back(), graph.local.back())));
      }
    for (std::size_t i = first; i < std::min(nodes, first + lane_width); ++i) {
      double volume = 0;
      for (const int touch : touches[i]) volume += mesh.volumes[touch / (D + 1)];
      graph.size.push_back(std::pow(simplices * volume / static_cast<double>(touches[i].size()), 1.0 / D));
      graph.touch_start.push_back(begin + static_cast<int>(i - first));
      graph.touch_ends.push_back(graph.touch_start.back() + static_cast<int>(touches[i].size()) * lane_width);
    }
  }
  graph.touch_start.push_back(static_cast<int>(graph.element.size()));
  graph.gradient.assign(graph.element.size() * D, 0.0);
  for (int i = 0; i < mesh.node_count(); ++i)
    for (int t = graph.touch_start[i]; t < graph.touch_end(i); t += graph.touch_stride) {
      const auto b = mesh::find_shape_gradient(mesh, graph.element[t], graph.local[t]);
      for (int d = 0; d < D; ++d) graph.gradient[find_component<D, lane_width>(t, d)] = b[d];
    }
  graph.nodes.assign(graph.lanes * (D + 1), 0);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) graph.nodes[graph.find_corner(e, k)] = mesh.elements[e][k];
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
      for (int t = graph.touch_start[i]; t < graph.touch_end(static_cast<int>(i)); t += graph.touch_stride)
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
