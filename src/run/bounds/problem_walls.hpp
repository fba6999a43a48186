// SPDX-License-Identifier: MIT
#pragma once
// Walls in limit analysis: those of FEM as rigid-plastic beams.

#include <vector>

#include "bounds/problem.hpp"
#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Returns `plan` with the walls of a case as lines, with points where struts and heads of bars act on them.
mesh::Plan conform_to_loaded_walls(const site::Site& site, mesh::Plan plan);

/// Adds the walls on a mesh of that plan to a problem that has its triangles; `number`: of the nodes in the problem, to
/// which those of walls in the air are added. Throws Error (wrong_input) for a wall without a strength of its
/// interface, for walls that lie on each other, for a strut without a free side, and what make_walls() throws.
void add_walls(const site::Site& site, const mesh::Mesh<2>& mesh, std::vector<int>& number, bounds::Problem& problem);

}  // namespace talus::run
