// SPDX-License-Identifier: MIT
#pragma once
// Boundary conditions and tractions of a case, resolved on a body's mesh.

#include "ground/mesh_sides.hpp"
#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Fills body.conditions. Several boundaries may meet at a node: fixed directions add up, a prescribed velocity wins
/// over them. Throws Error (wrong_input) for a side that the mesh does not have, with the names it has.
template <int D>
void resolve_conditions(mpm::Body<D>& body, const input::Case& data);

/// Adds `force` [N] to the points of the element that lie nearest to one of its sides, in equal shares (2.32).
template <int D>
void load_nearest_points(const mpm::Body<D>& body, const ground::SideElement& side,
                         const std::type_identity_t<Vec<D>>& force, mpm::Load<D>& load);

// Where pore water is held, and its conditions where the wet soil ends: [[hydraulic]] and [[boundary]] on a body's
// mesh.

/// Fills the conditions of body.water; nothing when the body is dry.
///
/// Water does not cross a side that holds the soil along its normal, unless a [[hydraulic]] other than no_flow is on
/// it, nor a line with no_flow inside the soil. Every other side of the wet soil at the start has a condition: that of
/// its
/// [[hydraulic]], or number 0, a seepage face. A node that lies on none of these sides takes the condition of the
/// nearest, so that conditions go with a free surface that moves; those of walls stay with the elements at the wall.
/// Throws Error (wrong_input) for a side that the mesh does not have, and for a condition on no side of the wet soil.
template <int D>
void resolve_water_conditions(mpm::Body<D>& body, const input::Case& data);

/// Makes the values that conditions have at `time` [s] constant: those that belong to pore pressures which are held.
template <int D>
void hold_surfaces(mpm::Body<D>& body, double time);

}  // namespace talus::run
