// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a run: properties, initial state, conditions and budget (`Water` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "mesh/mesh.hpp"
#include "report/report.hpp"

namespace talus::report {

// The hydraulic conditions of a case as a person reads them (`HydraulicCondition` in web/src/contract/).

/// "total head" for the word "total_head" of a condition.
std::string name_condition(std::string word);

/// One entry for each [[hydraulic]]; their lines in 2D from the mesh, or from the geometry where there is none.
nlohmann::json list_hydraulics(const ResultFolder& folder, const std::optional<mesh::Mesh<2>>& mesh);

// The hydraulic laws of the soils of a run (`SoilWater` in web/src/contract/).

/// Whether some soil of the case has pore water.
bool is_wet(const ResultFolder& folder);

/// Greatest suction that the results know of, in the model or in the seepage at its start [Pa]; nothing when unknown or
/// when there is none.
std::optional<double> find_largest_suction(const results::RunResult& run);

/// S of the soil at a suction [Pa].
double find_saturation(const input::PoreWater& soil, double suction);

/// The laws, their parameters and curves; null for a dry soil.
nlohmann::json describe_soil_water(const ResultFolder& folder, const input::PoreWater& soil);

/// Null where the ground is dry.
nlohmann::json make_water(const ResultFolder& folder);

}  // namespace talus::report
