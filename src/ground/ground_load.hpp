// SPDX-License-Identifier: MIT
#pragma once
// Loads on the ground for finite elements: surcharges, standing water, tractions on named sides.

#include <vector>

#include "fem/solid/solid.hpp"
#include "ground/initial_water.hpp"
#include "input/case/case.hpp"
#include "mesh/plan.hpp"

namespace talus::ground {

/// A side of the soil that faces upwards and has no soil behind it.
template <int D>
struct GroundSide {
  std::array<int, D> nodes{};
  Vec<D> normal{};  ///< unit, out of the soil
};
template <int D>
std::vector<GroundSide<D>> find_ground_sides(const mesh::Mesh<D>& mesh);

/// What lies on the ground and on named sides, as tractions linear on each side with the force and the moment of the
/// load. `table`: water table, may be empty; standing water is that of find_standing_level().
template <int D>
std::vector<fem::SurfaceLoad<D>> make_surface_loads(const input::Case& data, const mesh::Mesh<D>& mesh,
                                                    const std::vector<Pond>& ponds, const Polyline& table,
                                                    const Polyline& ground);

/// Surcharge [Pa per horizontal metre] at x: the sum of all.
double find_surcharge(const input::Case& data, double x);

// A plan whose mesh has nodes wherever a load on the ground begins, ends or bends.

/// `plan` with more corners in its polygons: on the ground at the ends and breaks of surcharges, at the ends of ponds,
/// under the breaks of a water table that lies above the ground, and where that table meets the ground. A traction
/// that is linear on each side of the mesh is then the load itself. A ready mesh, and a plan in 3D, stay as they are.
mesh::Plan conform_to_loads(const input::Case& data, mesh::Plan plan);

}  // namespace talus::ground
