// SPDX-License-Identifier: MIT
#pragma once
// Pore water that was found before as the start of another calculation, on any mesh of the same section.

#include <vector>

#include "base/vec.hpp"
#include "input/case/start.hpp"

namespace talus::ground {

struct MappedWater {
  std::vector<double> pressure;  ///< at the nodes, positive in tension [Pa]
  std::vector<Vec<2>> seepage;   ///< by element, Darcy's, of the whole area [m/s]
};

/// At the nodes of `mesh` linear in the triangle that holds them, or that is nearest where a rounding is outside of
/// all; in its elements that of the triangle around their middle. On the mesh that it is from, the same numbers.
MappedWater map_water(const input::KnownWater& known, const mesh::Mesh<2>& mesh);

}  // namespace talus::ground
