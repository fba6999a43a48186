// SPDX-License-Identifier: MIT
#pragma once
// Boundary conditions, tractions, loads on the ground and hydraulic conditions of a case on the mesh of a body.

#include <vector>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"

namespace talus::run {

// Boundary conditions and tractions of a case, and its hydraulic conditions ([[hydraulic]] and [[boundary]]), resolved
// on the mesh of a body.

/// Fills body.conditions. Several boundaries may meet at a node: their fixed directions are combined, and a prescribed
/// velocity takes precedence. Throws Error (wrong_input) for a side that the mesh does not have, with the names of its
/// sides.
template <int D>
void resolve_conditions(mpm::Body<D>& body, const input::Case& data);

/// Distributes `force` [N] equally among the points of the element nearest to one of its sides (2.32).
template <int D>
void load_nearest_points(const mpm::Body<D>& body, const site::SideElement& side,
                         const std::type_identity_t<Vec<D>>& force, mpm::Load<D>& load);

/// Fills the conditions of body.water; has no effect on a dry body.
///
/// Water does not cross a side at which the soil is fixed along the normal, unless that side has a [[hydraulic]] other
/// than no_flow, nor a line with no_flow inside the soil. Every other side of the initial wet soil has a condition:
/// that of its [[hydraulic]], or number 0, a seepage face. A node on none of these sides has the condition of the
/// nearest side, so that conditions move with a free surface; those of walls stay with the elements at the wall.
/// Throws Error (wrong_input) for a side that the mesh does not have, and for a condition on no side of the wet soil.
template <int D>
void resolve_water_conditions(mpm::Body<D>& body, const input::Case& data);

/// Fills the water uptake by roots of the points of a body on its initial mesh. Throws as find_root_distribution().
template <int D>
void resolve_root_uptakes(mpm::Body<D>& body, const input::Case& data);

/// Makes the values of the hydraulic conditions constant at those of `time` [s], in accordance with fixed pore
/// pressures.
template <int D>
void hold_surfaces(mpm::Body<D>& body, double time);

// Loads on the ground, and fixed pore pressures in soil without a phase of water, as loads of a body.

/// Returns the pore pressures and weights of water that is no phase of the engine; empty lists if there are none. In a
/// case with a phase of water only r_u contributes, and elements whose weight is that of the engine have none. Throws
/// Error (wrong_input) if given pressures act in other soil there whose strength depends on them.
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
