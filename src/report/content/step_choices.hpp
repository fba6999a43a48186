#pragma once
// How a case calculates its stages and trials, gathered from the echo of the input.

#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace talus::report {

/// What the stages, the curve's trials and the frozen factor's trials use, as far as the case runs them.
struct StepChoices {
  std::set<std::string> integrations, smoothings;
  double largest_damping = 0, largest_mass_scaling = 1;
  bool has_curve = false, has_frozen = false;
  bool is_reduction = false;         ///< analysis.kind is strength_reduction
  bool curve_is_smoothed = false;    ///< the curve's trials avoid locking
  bool stages_are_smoothed = false;  ///< the last stage does
};

StepChoices gather_step_choices(const nlohmann::json& summary);

}  // namespace talus::report
