#include "report/content/step_choices.hpp"

#include <algorithm>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

StepChoices gather_step_choices(const json& summary) {
  StepChoices choices;
  const auto add = [&](const json& step) {
    choices.integrations.insert(get_word(step, "integration", "mixed"));
    choices.smoothings.insert(get_word(step, "smoothing", "none"));
    choices.largest_damping = std::max(choices.largest_damping, get_si(step, "damping", 0));
    choices.largest_mass_scaling = std::max(choices.largest_mass_scaling, get_si(step, "mass_scaling", 1));
  };
  for (const json& stage : find_list(summary, {"input", "stage"})) {
    add(stage);
    choices.stages_are_smoothed = get_word(stage, "smoothing", "none") != "none";
  }
  const json* analysis = find(summary, {"input", "analysis"});
  choices.is_reduction = analysis != nullptr && get_word(*analysis, "kind") == "strength_reduction";
  if (!choices.is_reduction) return choices;
  if (const json* curve = find(summary, {"input", "strength_reduction", "curve"});
      curve && get_flag(*curve, "enabled")) {
    choices.has_curve = true;
    choices.curve_is_smoothed = get_word(*curve, "smoothing", "none") != "none";
    add(*curve);
  }
  if (const json* frozen = find(summary, {"input", "strength_reduction", "frozen"});
      frozen && get_flag(*frozen, "enabled")) {
    choices.has_frozen = true;
    add(*frozen);
  }
  return choices;
}

}  // namespace talus::report
