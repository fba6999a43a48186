// SPDX-License-Identifier: MIT
#pragma once
// Boundary conditions and tractions of a case, resolved on a body's mesh.

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Fills body.conditions. Several boundaries may meet at a node: fixed directions add up, a prescribed velocity wins
/// over them. Throws Error (wrong_input) for a side that the mesh does not have, with the names it has.
template <int D>
void resolve_conditions(mpm::Body<D>& body, const input::Case& data);

}  // namespace talus::run
