// SPDX-License-Identifier: MIT
#pragma once
// Loads on the ground, and fixed pore pressures in soil without a phase of water, as loads of a body.

#include <vector>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "site/pore_water.hpp"

namespace talus::run {

/// Returns the pore pressures and weights of water that is no phase of the engine; empty lists if there are none. In a
/// case with a phase of water only r_u contributes, and the weights are those of the engine.
template <int D>
site::HeldWater<D> find_carried_water(const input::Case& data, const mesh::Mesh<D>& mesh);

/// Surcharge and standing water above each point [Pa]. Water above a [[hydraulic]] is left out, as the engine applies
/// it.
template <int D>
std::vector<double> find_ground_load(const site::Site& site, const std::vector<Vec<D>>& places);

/// Adds surcharges, standing water and the forces of the fixed pore pressures to the loads of a body that was just
/// filled. They grow with the weight of the first stage. If a stage moves the soil through the mesh, the points carry
/// the loads on the ground; at frozen geometry the sides of the mesh carry them, which is exact.
template <int D>
void add_ground_loads(mpm::Body<D>& body, const site::Site& site, const site::HeldWater<D>& held);

}  // namespace talus::run
