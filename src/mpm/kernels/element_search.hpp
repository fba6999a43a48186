// SPDX-License-Identifier: MIT
#pragma once
// Search of the element that holds a point, by walking through element sides.

#include "mesh/mesh.hpp"

namespace talus::mpm {

/// Distance outside the grid, in shape functions, up to which a point counts as on the boundary (round-off).
inline constexpr double outside_tolerance = 1e-9;
inline constexpr int longest_walk = 1000;

/// Walks from `element` to the element that holds the point with local coordinates `xi`, and updates both. Returns
/// false if the point is outside the grid. M: mesh::Mesh, or the mesh on a GPU.
template <int D, class M>
TALUS_PORTABLE bool find_new_element(const M& mesh, int& element, double* xi) {
  for (int i = 0; i < longest_walk; ++i) {
    double shape[D + 1];
    shape[0] = 1;
    for (int k = 0; k < D; ++k) {
      shape[k + 1] = xi[k];
      shape[0] -= xi[k];
    }
    // `worst`: the side that the point is farthest outside of; `way`: the same among sides with a neighbour.
    int worst = -1, way = -1;
    for (int k = 0; k <= D; ++k) {
      if (!(shape[k] < 0)) continue;
      if (worst < 0 || shape[k] < shape[worst]) worst = k;
      if (mesh.neighbours[element][k] >= 0 && (way < 0 || shape[k] < shape[way])) way = k;
    }
    if (worst < 0) return true;
    if (way < 0) {
      if (shape[worst] < -outside_tolerance) return false;
      double sum = 0;
      for (double& s : shape) {
        s = s < 0 ? 0.0 : s;
        sum += s;
      }
      for (int k = 0; k < D; ++k) xi[k] = shape[k + 1] / sum;
      return true;
    }
    std::array<double, D> local;
    for (int k = 0; k < D; ++k) local[k] = xi[k];
    const std::array<double, D> x = mesh::find_place(mesh, element, local);
    element = mesh.neighbours[element][way];
    local = mesh::find_local(mesh, element, x);
    for (int k = 0; k < D; ++k) xi[k] = local[k];
  }
  return false;
}

}  // namespace talus::mpm
