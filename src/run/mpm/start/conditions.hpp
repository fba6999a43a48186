// SPDX-License-Identifier: MIT
#pragma once
// Boundary conditions and tractions of a case, resolved on a body's mesh.

#include "ground/side_normals.hpp"
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

}  // namespace talus::run
