// SPDX-License-Identifier: MIT
#pragma once
// The model of a case in a report (`Model` in web/src/contract/), with its named boundaries as polylines.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

using Polyline = std::vector<std::array<double, 2>>;

/// Joins sides of a mesh to polylines; nodes on straight stretches are omitted.
std::vector<Polyline> join_sides(const mesh::Mesh<2>& mesh, const std::vector<mesh::Mesh<2>::Side>& sides);

/// Returns the polylines of the boundary `name`: from the mesh if it is stored, otherwise from the box and the lines of
/// the case.
std::vector<Polyline> find_boundary_lines(const std::string& name, const mesh::Plan& plan,
                                          const std::optional<mesh::Mesh<2>>& mesh);

/// Returns the model. The strength "at failure" is divided by `factor_of_safety`. The mesh is packed if the folder
/// contains one that is small enough to be drawn.
nlohmann::json make_model(const ResultFolder& folder, std::optional<double> factor_of_safety, Packer& packer);

}  // namespace talus::report
