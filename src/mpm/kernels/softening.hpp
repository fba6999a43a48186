// SPDX-License-Identifier: MIT
#pragma once
// Nonlocal averaging of softening (theory 23): plastic volumetric strain is averaged over the neighbourhood of an
// element, so that the nonlocal length, not the element size, decides the width of a shear band.

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Nonlocal correction ε̄_e - ε_e of the dilation of element `e` (T23.1, T23.2). List: a SofteningReach, or the same on
/// a GPU.
template <class List, class E>
TALUS_PORTABLE double find_nonlocal_correction(const List& reach, const E& elements, std::size_t e) {
  if (!(elements.softening_volume[e] > 0)) return 0;
  double softened = 0, volume = 0;
  for (auto k = static_cast<std::size_t>(reach.start[e]); k < static_cast<std::size_t>(reach.start[e + 1]); ++k) {
    const auto other = static_cast<std::size_t>(reach.element[k]);
    softened += reach.weight[k] * elements.softened[other];
    volume += reach.weight[k] * elements.softening_volume[other];
  }
  return volume > 0 ? softened / volume - elements.softened[e] / elements.softening_volume[e] : 0;
}

/// Neighbours and weights for the nonlocal length `length` [m].
template <int D>
SofteningReach find_softening_reach(const mesh::Mesh<D>& mesh, double length);

/// Sets the nonlocal length [m] of a body, for the steps from now on.
template <int D>
void set_softening_length(Body<D>& body, double length);

/// Computes the nonlocal correction of each element from the dilation of the last step (T23.2). Reads and clears
/// softened and softening_volume; writes nonlocal_correction.
template <int D>
void average_softening(Body<D>& body, int threads);

}  // namespace talus::mpm
