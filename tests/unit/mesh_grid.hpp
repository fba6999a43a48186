// SPDX-License-Identifier: MIT
#pragma once
// Regular meshes with known numbering.

#include <algorithm>
#include <array>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// n × m squares of edge `h`, each split along its rising diagonal; region 0, nothing finished.
inline Mesh<2> make_grid(int n, int m, double h) {
  Mesh<2> mesh;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) mesh.nodes.push_back({i * h, j * h});
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.elements.push_back({a, b, d});
      mesh.elements.push_back({a, d, c});
    }
  mesh.element_region.assign(mesh.elements.size(), 0);
  mesh.region_names = {"soil"};
  return mesh;
}

/// n × m × l cubes of edge `h`, each split into six tetrahedra around its diagonal (Kuhn); orientation as it comes.
inline Mesh<3> make_grid(int n, int m, int l, double h) {
  Mesh<3> mesh;
  for (int k = 0; k <= l; ++k)
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) mesh.nodes.push_back({i * h, j * h, k * h});
  const std::array<int, 3> stride{1, n + 1, (n + 1) * (m + 1)};
  for (int k = 0; k < l; ++k)
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = i * stride[0] + j * stride[1] + k * stride[2];
        std::array<int, 3> axis{0, 1, 2};
        do {
          const int b = a + stride[axis[0]], c = b + stride[axis[1]];
          mesh.elements.push_back({a, b, c, c + stride[axis[2]]});
        } while (std::next_permutation(axis.begin(), axis.end()));
      }
  mesh.element_region.assign(mesh.elements.size(), 0);
  mesh.region_names = {"soil"};
  return mesh;
}

template <int D>
std::array<double, D> get_centroid(const Mesh<D>& mesh, int e) {
  typename Mesh<D>::Point xi;
  xi.fill(1.0 / (D + 1));
  return to_global(mesh, e, xi);
}

}  // namespace talus::mesh
