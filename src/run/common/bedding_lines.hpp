// SPDX-License-Identifier: MIT
#pragma once
// Lines of the mesh along bedding. The velocities of FEM and limit analysis are continuous: soil slips on its bedding
// without straining otherwise only between two lines of the mesh in that direction.

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Returns the mesh of the plan with lines along the bedding of each polygon, through its corners and at most `spacing`
/// element sizes apart; without them where the mesh generator does not cope, as with lines that nearly touch.
mesh::Mesh<2> generate_with_bedding(const site::Site& site, const mesh::Plan& plan, double spacing);

}  // namespace talus::run
