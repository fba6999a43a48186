#pragma once
// The hydraulic conditions of a case as a person reads them (`HydraulicCondition` in web/src/contract/).

#include <nlohmann/json.hpp>
#include <optional>

#include "mesh/mesh.hpp"

namespace talus::report {

/// "total head" for "total_head".
std::string name_condition(const std::string& condition);

/// One entry for each [[hydraulic]]; their lines in 2D from the mesh, or from the geometry where there is none.
nlohmann::json list_hydraulics(const nlohmann::json& summary, const std::optional<mesh::Mesh<2>>& mesh);

}  // namespace talus::report
