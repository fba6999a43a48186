#pragma once
// What the soils of a run do with pore water, from the echo of its input (`SoilWater` in web/src/contract/).

#include <nlohmann/json.hpp>
#include <optional>

#include "input/case/water.hpp"

namespace talus::report {

/// [materials.NAME.water] as it was understood; a dry soil when the echo of the material has none.
input::PoreWater read_pore_water(const nlohmann::json& material);
/// [water], with the program's defaults where the echo has nothing.
input::Water read_water(const nlohmann::json& summary);

/// Whether some soil of the case has pore water.
bool is_wet(const nlohmann::json& summary);

/// Greatest suction that the results know of, in the model or in the seepage at its start [Pa]; nothing when unknown or
/// when there is none.
std::optional<double> find_largest_suction(const nlohmann::json& summary);

/// S of the soil at a suction [Pa].
double find_saturation(const input::PoreWater& soil, double suction);

/// The laws, their parameters and curves; null for a dry soil.
nlohmann::json describe_soil_water(const nlohmann::json& summary, const nlohmann::json& material);

}  // namespace talus::report
