// SPDX-License-Identifier: MIT
#pragma once
// Stress and pore water of an earlier result as the start of another calculation, on any mesh of the same section.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "input/case/start.hpp"

namespace talus::site {

struct StressAt {
  std::array<double, 6> stress{};  ///< effective, positive in tension [Pa]
  double plastic_strain = 0;       ///< accumulated deviatoric [-]
};

/// Interpolates a known stress field: linear between the integration points of the triangle that contains the point,
/// with the plastic strain of the nearest of them. On the mesh of the field it is the triangle of the same number.
/// Points outside all triangles take the triangle with soil whose smallest shape function at the point is largest.
class StressReader {
 public:
  StressReader(const input::KnownStress& known, const mesh::Mesh<2>& mesh);

  /// Returns the state at the local coordinates `xi` of element `e` of the mesh.
  StressAt read(int e, const Vec<2>& xi);

 private:
  int find_soil(const Vec<2>& x) const;

  const input::KnownStress& known_;
  const mesh::Mesh<2>& mesh_;
  bool same_mesh_;
  int last_ = 0;
};

// Pore water of an earlier result as the start of another calculation, on any mesh of the same section.

struct MappedWater {
  std::vector<double> pressure;  ///< at the nodes, positive in tension [Pa]
  std::vector<Vec<2>> seepage;   ///< Darcy velocity per element [m/s]
};

/// Maps known water to `mesh`. Nodes: linear in the triangle that contains them, or in the nearest one for points that
/// rounding puts outside of all. Elements: the velocity of the triangle around their middle. On the mesh of the known
/// water the numbers are unchanged.
MappedWater map_water(const input::KnownWater& known, const mesh::Mesh<2>& mesh);

}  // namespace talus::site
