// SPDX-License-Identifier: MIT
#pragma once
// The hydraulic conditions of a case as a person reads them (`HydraulicCondition` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "mesh/mesh.hpp"
#include "report/folder.hpp"

namespace talus::report {

/// "total head" for the word "total_head" of a condition.
std::string name_condition(std::string word);

/// One entry for each [[hydraulic]]; their lines in 2D from the mesh, or from the geometry where there is none.
nlohmann::json list_hydraulics(const ResultFolder& folder, const std::optional<mesh::Mesh<2>>& mesh);

}  // namespace talus::report
