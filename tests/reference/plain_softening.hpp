// SPDX-License-Identifier: MIT
#pragma once
// Nonlocal softening (docs/theory/23-softening-length.md) in plain loops.

#include <cmath>
#include <vector>

#include "mesh/mesh.hpp"

namespace talus::reference {

/// Nonlocal correction of the plastic dilation of each element, ε̄_e − ε_e of (T23.1), from the sums Σ V_p Δε and Σ V_p
/// of the elements.
template <int D>
std::vector<double> find_nonlocal_correction(const mesh::Mesh<D>& mesh, const std::vector<double>& softened,
                                             const std::vector<double>& volume, double length) {
  const std::size_t count = mesh.elements.size();
  const auto find_distance = [&](std::size_t e, std::size_t f) {
    double square = 0;
    for (std::size_t d = 0; d < D; ++d) {
      double between = 0;
      for (std::size_t k = 0; k <= D; ++k)
        between += mesh.nodes[static_cast<std::size_t>(mesh.elements[f][k])][d] -
                   mesh.nodes[static_cast<std::size_t>(mesh.elements[e][k])][d];
      square += between / (D + 1) * between / (D + 1);
    }
    return std::sqrt(square);
  };
  std::vector<double> nonlocal_correction(count, 0);
  for (std::size_t e = 0; e < count; ++e) {
    if (volume[e] == 0) continue;
    double above = 0, below = 0;
    for (std::size_t f = 0; f < count; ++f) {
      const double r = find_distance(e, f) / length;
      if (r >= 2) continue;
      above += r * std::exp(-r * r) * softened[f];
      below += r * std::exp(-r * r) * volume[f];
    }
    if (below > 0) nonlocal_correction[e] = above / below - softened[e] / volume[e];
  }
  return nonlocal_correction;
}

}  // namespace talus::reference
