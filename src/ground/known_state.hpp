// SPDX-License-Identifier: MIT
#pragma once
// Stress that finite elements found before as the start of another calculation, on any mesh of the same section.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "input/case/start.hpp"

namespace talus::ground {

struct StressAt {
  std::array<double, 6> stress{};  ///< effective, positive in tension [Pa]
  double plastic_strain = 0;       ///< accumulated, deviatoric [-]
};

/// Reads known stress at places of a mesh: that of the triangle that holds the place, linear between its integration
/// points, with the plastic strain of the nearest of them. On the mesh that the stress is from, the triangle of that
/// number. Places outside of all take the triangle with soil whose least shape function there is the greatest.
class StressReader {
 public:
  StressReader(const input::KnownStress& known, const mesh::Mesh<2>& mesh);

  /// At the local coordinates `xi` of element `e` of the mesh.
  StressAt read(int e, const Vec<2>& xi);

 private:
  int find_soil(const Vec<2>& x) const;

  const input::KnownStress& known_;
  const mesh::Mesh<2>& mesh_;
  bool same_mesh_;
  int last_ = 0;
};

// Pore water that was found before as the start of another calculation, on any mesh of the same section.

struct MappedWater {
  std::vector<double> pressure;  ///< at the nodes, positive in tension [Pa]
  std::vector<Vec<2>> seepage;   ///< by element, Darcy's, of the whole area [m/s]
};

/// At the nodes of `mesh` linear in the triangle that holds them, or that is nearest where a rounding is outside of
/// all; in its elements that of the triangle around their middle. On the mesh that it is from, the same numbers.
MappedWater map_water(const input::KnownWater& known, const mesh::Mesh<2>& mesh);

}  // namespace talus::ground
