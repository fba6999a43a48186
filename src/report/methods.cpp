#include "report/methods.hpp"

#include "report/look_up.hpp"
#include "report/step_choices.hpp"

namespace talus::report {

using nlohmann::json;

json list_methods(const json& summary) {
  const StepChoices choices = gather_step_choices(summary);
  json methods{"material_point_method", "time_step"};
  const auto add_if = [&](bool applies, const char* name) {
    if (applies) methods.push_back(name);
  };
  add_if(choices.integrations.contains("mixed"), "mixed_integration");
  add_if(choices.integrations.contains("points"), "point_integration");
  add_if(choices.smoothings.contains("strain"), "strain_smoothing");
  add_if(choices.smoothings.contains("stable"), "stable_smoothing");
  add_if(choices.largest_damping > 0, "local_damping");
  add_if(choices.largest_mass_scaling > 1, "mass_scaling");
  bool plastic = false, elastic = false;
  if (const json* materials = find(summary, {"input", "materials"}))
    for (const json& m : *materials) {
      plastic = plastic || get_word(m, "model") == "mohr_coulomb";
      elastic = elastic || get_word(m, "model") == "linear_elastic";
    }
  add_if(plastic, "mohr_coulomb");
  add_if(elastic, "linear_elastic");
  add_if(choices.is_reduction, "strength_reduction");
  add_if(choices.has_curve, "displacement_curve");
  add_if(choices.has_frozen, "frozen_factor");
  add_if(find(summary, {"runout"}) != nullptr || !find_list(summary, {"runouts"}).empty(), "runout");
  return methods;
}

}  // namespace talus::report
