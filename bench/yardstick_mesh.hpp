// SPDX-License-Identifier: MIT
#pragma once
// Mesh of the benchmark slope, identical to that of the yardstick: a box of jittered squares or cubes, divided into
// simplices.

#include <array>
#include <map>
#include <random>
#include <string>

#include "mesh/mesh.hpp"

namespace talus::bench {

struct YardstickCase {
  std::array<int, 3> cells;  ///< number of squares or cubes per direction
  double size;               ///< edge length of the cells [m]
  int filled_elements;
  int points_per_element;
};

template <int D>
YardstickCase yardstick_case(const std::string& name) {
  static const std::map<std::string, YardstickCase> plane{{"small", {{73, 21, 0}, 1.0, 1792, 3}},
                                                          {"mid", {{292, 84, 0}, 0.25, 28672, 3}},
                                                          {"large", {{998, 287, 0}, 0.0731, 334300, 3}},
                                                          {"huge", {{2232, 642, 0}, 0.0327, 1671500, 3}}};
  static const std::map<std::string, YardstickCase> space{{"small", {{24, 10, 4}, 1.0, 2600, 4}},
                                                          {"mid", {{60, 25, 10}, 0.4, 40000, 4}},
                                                          {"large", {{110, 46, 19}, 0.22, 250000, 4}},
                                                          {"huge", {{188, 79, 33}, 0.1287, 1250000, 4}}};
  return D == 2 ? plane.at(name) : space.at(name);
}

template <int D>
mesh::Mesh<D> make_yardstick_mesh(const YardstickCase& c) {
  mesh::Mesh<D> mesh;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.18, 0.18);
  const int nx = c.cells[0], ny = c.cells[1], nz = D == 3 ? c.cells[2] : 0;
  const double scale = D == 3 ? 0.6 : 1.0;
  const auto number = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        std::array<double, D> x;
        x[0] = (i + (i > 0 && i < nx ? jitter(random) * scale : 0)) * c.size;
        x[1] = (j + (j > 0 && j < ny ? jitter(random) * scale : 0)) * c.size;
        if constexpr (D == 3) x[2] = (k + (k > 0 && k < nz ? jitter(random) * scale : 0)) * c.size;
        mesh.nodes.push_back(x);
      }
    }
  }
  if constexpr (D == 2) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const int p = number(i, j, 0), q = number(i + 1, j, 0), r = number(i + 1, j + 1, 0), s = number(i, j + 1, 0);
        if (random() & 1) {
          mesh.elements.push_back({p, q, r});
          mesh.elements.push_back({p, r, s});
        } else {
          mesh.elements.push_back({p, q, s});
          mesh.elements.push_back({q, r, s});
        }
      }
    }
  } else {
    constexpr int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int k = 0; k < nz; ++k) {
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          for (const auto& path : paths) {  // Kuhn's division of a cube into six tetrahedra
            int at[3] = {i, j, k};
            std::array<int, 4> t{number(i, j, k), 0, 0, 0};
            for (std::size_t s = 0; s < 3; ++s) {
              ++at[path[s]];
              t[s + 1] = number(at[0], at[1], at[2]);
            }
            mesh.elements.push_back(t);
          }
        }
      }
    }
  }
  mesh.element_region.assign(mesh.elements.size(), mesh::empty_region);
  mesh::finish(mesh);
  return mesh;
}

}  // namespace talus::bench
