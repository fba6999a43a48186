// SPDX-License-Identifier: MIT
#include "app/case_options.hpp"

#include "base/error.hpp"
#include "report/report.hpp"

namespace talus::app {

void CaseOptions::add_to(const Command& command) {
  command.take("case", file, "The case file (TOML)").shown_as("CASE").required();
  // --set takes one value each time, since "--set a=1 case.toml" would otherwise take the case file as a second
  // change.
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

void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    const ExitCode code = explain_failure(std::current_exception()).code;
    // Input errors and an occupied folder are found before anything is written: existing files belong to another run.
    const bool has_begun = code != ExitCode::wrong_input && code != ExitCode::folder_exists;
    // After an interruption no report is written; `talus report` can write it from the existing files.
    if (wants_report && has_begun && code != ExitCode::interrupted) {
      try {
        report::write_report(folder);
      } catch (...) {  // the first error is the one to report
      }
    }
    throw;
  }
  if (wants_report) report::write_report(folder);
}

}  // namespace talus::app
