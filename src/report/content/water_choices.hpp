#pragma once
// What pore water does in the stages and trials of a wet case, gathered from the echo of the input.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::report {

/// A stage of the case, or the trials of one search.
struct WaterPart {
  std::string name;  ///< "stage 'gravity'", "the trials of the curve"
  bool flows = true;
  bool is_frozen_geometry = false;
  double conductivity_factor = 1, mass_scaling = 1, damping = 0;
  bool has_explicit_drag = false, damps_without_drag = false, smooths_pressure = false;
};

/// The parts that are run, stages first.
std::vector<WaterPart> list_water_parts(const nlohmann::json& summary);

/// "flows" or "held": what water does in the trials of a search, "curve" or "frozen"; empty where there is none.
std::string find_water_of_trials(const nlohmann::json& summary, const char* search);

/// The clause of a stage's description on its pore water, with a comma in front; empty where water simply flows.
std::string describe_stage_water(const nlohmann::json& stage);

}  // namespace talus::report
