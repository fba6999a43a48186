// SPDX-License-Identifier: MIT
#pragma once
// The hydraulic condition of each side of the wet soil at the start: a wall, a surface with a condition, or an
// impervious line. Numbers of conditions: 0 surfaces without a name, then one for each [[hydraulic]], then one for
// each boundary that moves.

#include <utility>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/two_velocity/water.hpp"

namespace talus::ground {

/// A side of a wet element behind which there is no wet soil.
template <int D>
struct WaterSide {
  std::array<int, D> nodes{};
  int opposite = 0;      ///< node of the element that is not on the side
  Vec<D> normal{};       ///< unit, out of the soil
  bool is_wall = false;  ///< the soil's motion along its normal is held or prescribed
  int condition = 0;
};

template <int D>
struct WaterSides {
  std::vector<mpm::SurfaceCondition> surfaces;  ///< by the number of the condition; at least one
  std::vector<WaterSide<D>> open;               ///< where water may pass, or meets a skin that goes with the soil
  /// Sides that water does not cross, one list for each boundary or [[hydraulic]] that says so.
  std::vector<std::vector<std::array<int, D>>> held;
  /// Nodes on conditioned sides of walls without wet soil, with the condition: soil may come there.
  std::vector<std::pair<int, int>> reserved;
};

/// The condition of the engine for one [[hydraulic]]. Pressures change their sign: positive in tension.
mpm::SurfaceCondition make_surface_condition(const input::Hydraulic& hydraulic);

/// Throws Error (wrong_input) for a side that the mesh does not have, and for a condition on no side of the wet soil.
template <int D>
WaterSides<D> find_water_sides(const mesh::Mesh<D>& mesh, const input::Case& data);

/// Which of several conditions holds where they meet at the elevation `y` [m]: head, pressure, flux, rain, seepage, no
/// flow. A head is a seepage face above its level. Smaller comes first.
int find_rank(const mpm::SurfaceCondition& surface, double y, bool is_named);

}  // namespace talus::ground
