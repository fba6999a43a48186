// SPDX-License-Identifier: MIT
#pragma once
// The hydraulic laws of the soils of a run (`SoilWater` in web/src/contract/).

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/folder.hpp"

namespace talus::report {

/// Whether some soil of the case has pore water.
bool is_wet(const ResultFolder& folder);

/// Greatest suction that the results know of, in the model or in the seepage at its start [Pa]; nothing when unknown or
/// when there is none.
std::optional<double> find_largest_suction(const results::RunResult& run);

/// S of the soil at a suction [Pa].
double find_saturation(const input::PoreWater& soil, double suction);

/// The laws, their parameters and curves; null for a dry soil.
nlohmann::json describe_soil_water(const ResultFolder& folder, const input::PoreWater& soil);

}  // namespace talus::report
