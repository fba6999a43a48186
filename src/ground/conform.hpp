// SPDX-License-Identifier: MIT
#pragma once
// A plan whose mesh has nodes wherever a load on the ground begins, ends or bends.

#include "input/case/case.hpp"
#include "mesh/plan.hpp"

namespace talus::ground {

/// `plan` with more corners in its polygons: on the ground at the ends and breaks of surcharges, at the ends of ponds,
/// under the breaks of a water table that lies above the ground, and where that table meets the ground. A traction
/// that is linear on each side of the mesh is then the load itself. A ready mesh, and a plan in 3D, stay as they are.
mesh::Plan conform_to_loads(const input::Case& data, mesh::Plan plan);

}  // namespace talus::ground
