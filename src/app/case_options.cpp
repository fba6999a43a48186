// SPDX-License-Identifier: MIT
#include "app/case_options.hpp"

namespace talus::app {

void CaseOptions::add_to(CLI::App& command) {
  command.add_option("case", file, "The case file (TOML)")->type_name("CASE")->required();
  // One value each, or "--set a=1 case.toml" would take the case file for a second change.
  command
      .add_option("--set", sets, "Change a key of the case, for example --set materials.sand.cohesion=5; repeatable")
      ->type_name("KEY=VALUE")
      ->type_size(1)
      ->allow_extra_args(false);
}

std::vector<input::Override> CaseOptions::parse_overrides() const {
  std::vector<input::Override> overrides;
  for (const std::string& text : sets) overrides.push_back(input::parse_override(text));
  return overrides;
}

}  // namespace talus::app
