// SPDX-License-Identifier: MIT
#pragma once
// What lies on the ground, and pore pressures that are held in soil without a phase of water, as loads of a body.

#include <vector>

#include "ground/pore_water.hpp"
#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Pressures and weights that the points of a case carry beside the engine's own water; empty lists where there are
/// none. In a case with a phase of water only r_u counts here, and the weights are the engine's.
template <int D>
ground::HeldWater<D> find_carried_water(const input::Case& data, const mesh::Mesh<D>& mesh);

/// Surcharge and standing water over each place [Pa]. Water over a [[hydraulic]] is left out: the engine knows it.
template <int D>
std::vector<double> find_ground_load(const input::Case& data, const std::vector<Vec<D>>& places);

/// Adds surcharges, standing water and the forces of the held pressures to the loads of a body that was just filled.
/// They come on with the weight of the first stage. Where a stage moves the soil through the mesh, points carry what
/// lies on the ground; at frozen geometry the sides of the mesh do, which is exact.
template <int D>
void add_ground_loads(mpm::Body<D>& body, const input::Case& data, const ground::HeldWater<D>& held);

}  // namespace talus::run
