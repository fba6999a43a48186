// SPDX-License-Identifier: MIT
#pragma once
// Loads on the ground for finite elements: surcharges, standing water, tractions on named sides.

#include <vector>

#include "fem/solid/solid.hpp"
#include "ground/plane_water.hpp"
#include "input/case/case.hpp"

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

}  // namespace talus::ground
