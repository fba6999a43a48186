// SPDX-License-Identifier: MIT
#pragma once
// Softening over a length (theory 23). The plastic volume that softens an element is a mean over its neighbourhood, so
// that a band has the width that the length gives it, not that of an element.

#include <cstdint>
#include <vector>

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Which elements an element takes its mean over, and with which weights, before their volumes (T23.1).
struct SofteningReach {
  std::vector<std::int64_t> start;  ///< of element e: [start[e], start[e + 1])
  std::vector<int> element;
  std::vector<double> weight;
};

/// What element `e` takes over from its neighbourhood (T23.2). List: a SofteningReach, or the same on a GPU.
template <class List, class E>
TALUS_PORTABLE double find_lent(const List& reach, const E& elements, std::size_t e) {
  if (!(elements.softening_volume[e] > 0)) return 0;
  double softened = 0, volume = 0;
  for (auto k = static_cast<std::size_t>(reach.start[e]); k < static_cast<std::size_t>(reach.start[e + 1]); ++k) {
    const auto other = static_cast<std::size_t>(reach.element[k]);
    softened += reach.weight[k] * elements.softened[other];
    volume += reach.weight[k] * elements.softening_volume[other];
  }
  return volume > 0 ? softened / volume - elements.softened[e] / elements.softening_volume[e] : 0;
}

/// `length` in m.
template <int D>
SofteningReach find_softening_reach(const mesh::Mesh<D>& mesh, double length);

/// Lets the soil of a body soften over `length` [m] from the next step on.
template <int D>
void set_softening_length(Body<D>& body, double length);

/// What the points of each element take over from their neighbourhood, from what softened in the last step (T23.2).
/// Reads and clears softened and softening_volume; writes lent.
template <int D>
void lend_softening(Body<D>& body, int threads);

}  // namespace talus::mpm
