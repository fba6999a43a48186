// SPDX-License-Identifier: MIT
#pragma once
// Lines of the first mesh of limit analysis along which strength and pore pressure bend, so that they are linear in its
// triangles: levels of strengths, water tables, and the verticals below the vertices of these.

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Returns the mesh of the plan with such lines where they do not nearly touch others. Where the mesh generator does
/// not cope, where they make more than twice as many triangles, and in a mesh from a file there are none.
mesh::Mesh<2> generate_with_kinks(const site::Site& site, const mesh::Plan& plan);

}  // namespace talus::run
