// SPDX-License-Identifier: MIT
#pragma once
// Loads on the ground for FEM and limit analysis (surcharges, standing water, tractions on named sides), and meshes
// that conform to them.

#include <vector>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "mesh/plan.hpp"
#include "site/initial_water.hpp"

namespace talus::site {

/// A side of the soil that faces upwards and has no soil behind it.
template <int D>
struct GroundSide {
  std::array<int, D> nodes{};
  Vec<D> normal{};  ///< unit, out of the soil
};
template <int D>
std::vector<GroundSide<D>> find_ground_sides(const mesh::Mesh<D>& mesh);

/// Returns the loads on the ground and on named sides as tractions linear on each side, with the force and the moment
/// of the load. `table`: water table, may be empty; standing water is that of find_standing_level().
template <int D>
std::vector<fem::SurfaceLoad<D>> make_surface_loads(const input::Case& data, const mesh::Mesh<D>& mesh,
                                                    const std::vector<Pond>& ponds, const Polyline& table,
                                                    const Polyline& ground);

/// Returns the sum of all surcharges at x [Pa per horizontal metre].
double find_surcharge(const input::Case& data, double x);

// A plan whose mesh has nodes wherever a load on the ground begins, ends or changes its gradient.

/// Returns `plan` with additional corners in its polygons: on the ground at the ends and breaks of surcharges, at the
/// ends of ponds, under the vertices of a water table above the ground, and where that table meets the ground. A
/// traction linear on each side of the mesh then equals the load. A ready mesh and a plan in 3D are returned unchanged.
mesh::Plan conform_to_loads(const input::Case& data, mesh::Plan plan);

}  // namespace talus::site
