// SPDX-License-Identifier: MIT
#pragma once
// The ground of a plane section, the upper limit of all soil polygons.

#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

/// Returns the ground from left to right; a vertical step has two points of the same x. Throws Error (wrong_input),
/// with the place, if the soil has a gap, an overhang or a cavity, since LEM needs soil from the ground
/// down.
Polyline find_ground(const Plan& plan);

}  // namespace talus::mesh
