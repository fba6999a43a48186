// SPDX-License-Identifier: MIT
#include "app/case_options.hpp"

namespace talus::app {

void CaseOptions::add_to(const Command& command) {
  command.take("case", file, "The case file (TOML)").shown_as("CASE").required();
  // One value each, or "--set a=1 case.toml" would take the case file for a second change.
  command
      .take("--set", sets,
            "Change a key of the case, as in --set materials.sand.cohesion=5; KEY= without a value removes the key or "
            "table; repeatable")
      .shown_as("KEY=VALUE")
      .one_each();
}

std::vector<input::Override> CaseOptions::parse_overrides() const {
  std::vector<input::Override> overrides;
  for (const std::string& text : sets) overrides.push_back(input::parse_override(text));
  return overrides;
}

}  // namespace talus::app
