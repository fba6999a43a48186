// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a run in a report: properties, initial state, conditions and budget (`Water` in web/src/contract/), the
// hydraulic conditions (`HydraulicCondition`) and the hydraulic laws of the soils (`SoilWater`).

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "mesh/mesh.hpp"
#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns "total head" for the word "total_head" of a condition.
std::string name_condition(std::string word);

/// Returns one entry for each [[hydraulic]]. In 2D their polylines are from the mesh, or from the geometry without one.
nlohmann::json list_hydraulics(const ResultFolder& folder, const std::optional<mesh::Mesh<2>>& mesh);

/// Returns true if a soil of the case has pore water.
bool is_wet(const ResultFolder& folder);

/// Returns the largest suction of the results, in the model or in the seepage at its start [Pa]; nullopt if it is
/// unknown or there is none.
std::optional<double> find_largest_suction(const results::RunResult& run);

/// Returns the degree of saturation of the soil at a suction [Pa].
double find_saturation(const input::PoreWater& soil, double suction);

/// Returns the laws with parameters and curves; null for dry soil.
nlohmann::json describe_soil_water(const ResultFolder& folder, const input::PoreWater& soil);

/// Returns null if the ground is dry.
nlohmann::json make_water(const ResultFolder& folder);

}  // namespace talus::report
