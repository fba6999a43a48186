// SPDX-License-Identifier: MIT
#pragma once
// The calculation model as the report shows it (`Model` in web/src/contract/).

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "report/pack/pack.hpp"
#include "report/report.hpp"

namespace talus::report {

// Where the named sides of a plane case lie, as polylines.

using Polyline = std::vector<std::array<double, 2>>;

/// Sides of a mesh joined end to end; points on a straight stretch are left out.
std::vector<Polyline> join_sides(const mesh::Mesh<2>& mesh, const std::vector<mesh::Mesh<2>::Side>& sides);

/// The lines that `name` stands for: from the mesh where it is kept, else from the box and the lines of the case.
std::vector<Polyline> find_boundary_lines(const std::string& name, const mesh::Plan& plan,
                                          const std::optional<mesh::Mesh<2>>& mesh);

/// `factor_of_safety` is what the strength of the materials is divided by "at failure". The mesh is packed when the
/// folder holds one that is small enough to be drawn.
nlohmann::json make_model(const ResultFolder& folder, std::optional<double> factor_of_safety, Packer& packer);

}  // namespace talus::report
