// SPDX-License-Identifier: MIT
#pragma once
// Where the named sides of a plane case lie, as polylines.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::report {

using Polyline = std::vector<std::array<double, 2>>;

/// Sides of a mesh joined end to end; points on a straight stretch are left out.
std::vector<Polyline> join_sides(const mesh::Mesh<2>& mesh, const std::vector<mesh::Mesh<2>::Side>& sides);

/// The lines that `name` stands for: from the mesh where it is kept, else from the box and the lines of the case.
std::vector<Polyline> find_boundary_lines(const std::string& name, const mesh::Plan& plan,
                                          const std::optional<mesh::Mesh<2>>& mesh);

}  // namespace talus::report
