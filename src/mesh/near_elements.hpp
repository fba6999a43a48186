// SPDX-License-Identifier: MIT
#pragma once
// Search of the elements near an element, for averages over a neighbourhood (theory 23).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Element centroids in cells of the radius of the search: neighbours are in the same or in an adjacent cell.
template <int D>
class NearElements {
 public:
  NearElements(const Mesh<D>& mesh, double radius) : radius_(radius), centroids_(mesh.elements.size()) {
    for (std::size_t e = 0; e < centroids_.size(); ++e) {
      for (const int node : mesh.elements[e])
        for (int d = 0; d < D; ++d) centroids_[e][d] += mesh.nodes[static_cast<std::size_t>(node)][d] / (D + 1);
      cells_[find_cell(centroids_[e])].push_back(static_cast<int>(e));
    }
  }
  /// Calls work(element, distance) for the elements, `e` included, whose centroid is closer than the radius [m], in the
  /// order of their numbers.
  void visit(int e, auto&& work) const {
    std::vector<int> near;
    add_cells(find_cell(centroids_[static_cast<std::size_t>(e)]), 0, near);
    std::sort(near.begin(), near.end());
    for (const int other : near) {
      Vec<D> between = centroids_[static_cast<std::size_t>(other)];
      for (int d = 0; d < D; ++d) between[d] -= centroids_[static_cast<std::size_t>(e)][d];
      if (const double distance = norm(between); distance < radius_) work(other, distance);
    }
  }

 private:
  using Cell = std::array<long, D>;

  Cell find_cell(const Vec<D>& x) const {
    Cell cell;
    for (std::size_t d = 0; d < D; ++d) cell[d] = std::lround(std::floor(x[d] / radius_));
    return cell;
  }
  void add_cells(Cell cell, std::size_t d, std::vector<int>& near) const {
    if (d == D) {
      if (const auto found = cells_.find(cell); found != cells_.end())
        near.insert(near.end(), found->second.begin(), found->second.end());
      return;
    }
    const long middle = cell[d];
    for (cell[d] = middle - 1; cell[d] <= middle + 1; ++cell[d]) add_cells(cell, d + 1, near);
  }

  double radius_;
  std::vector<Vec<D>> centroids_;
  std::map<Cell, std::vector<int>> cells_;
};

}  // namespace talus::mesh
