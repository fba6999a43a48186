// SPDX-License-Identifier: MIT
#pragma once
// The gradient of a linear shape function: minus the normal of the side opposite its node, over the altitude.

#include <cstddef>

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// ∇N_k [1/m] of local node `k` in element `e` of a finished mesh, this one or that on a GPU.
template <template <int> class M, int D>
TALUS_PORTABLE std::array<double, D> find_shape_gradient(const M<D>& mesh, int e, int k) {
  const std::array<double, D* D>& g = mesh.gradients[static_cast<std::size_t>(e)];
  std::array<double, D> gradient{};
  for (std::size_t d = 0; d < D; ++d) {
    if (k > 0) {
      gradient[d] = g[static_cast<std::size_t>(k - 1) * D + d];
    } else {
      for (std::size_t j = 0; j < D; ++j) gradient[d] -= g[j * D + d];
    }
  }
  return gradient;
}

}  // namespace talus::mesh
