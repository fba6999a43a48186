// SPDX-License-Identifier: MIT
#pragma once
// The hydraulic condition of each side of the wet soil at the start: a wall, a surface with a condition, or an
// impermeable line. Numbers of conditions: 0 for unnamed surfaces, then one for each [[hydraulic]], then one for each
// moving boundary.

#include <utility>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/state/water.hpp"

namespace talus::site {

/// Name of the sides in a mesh through which no water passes: both faces of impermeable walls.
inline constexpr const char* impermeable_sides = "[support] impermeable";

/// A side of a wet element behind which there is no wet soil.
template <int D>
struct WaterSide {
  std::array<int, D> nodes{};
  int opposite = 0;      ///< node of the element that is not on the side
  Vec<D> normal{};       ///< unit, out of the soil
  bool is_wall = false;  ///< the motion of the soil along the normal is fixed or prescribed
  int condition = 0;
};

template <int D>
struct WaterSides {
  std::vector<mpm::SurfaceCondition> surfaces;  ///< by the number of the condition; at least one
  std::vector<WaterSide<D>> open;               ///< sides that water may cross, or with a moving impermeable skin
  /// Sides that water does not cross, one list for each boundary or [[hydraulic]] without flow.
  std::vector<std::vector<std::array<int, D>>> held;
  /// Nodes on conditioned sides of walls without wet soil, with the condition, since soil may move there.
  std::vector<std::pair<int, int>> reserved;
};

/// Returns the surface condition of MPM for one [[hydraulic]]. Pressures change their sign: positive in tension.
mpm::SurfaceCondition make_surface_condition(const input::Hydraulic& hydraulic);

/// Returns the sides of the wet soil. Throws Error (wrong_input) for a side that the mesh does not have, and for a
/// condition on no side of the wet soil.
template <int D>
WaterSides<D> find_water_sides(const mesh::Mesh<D>& mesh, const input::Case& data);

/// Returns the precedence of a condition where several meet at the elevation `y` [m]; the smallest rank applies: head,
/// pressure, flux, rain, seepage face, no flow. Above its level a head is a seepage face.
int find_rank(const mpm::SurfaceCondition& surface, double y, bool is_named);

}  // namespace talus::site
