// SPDX-License-Identifier: MIT
#pragma once
// Arguments of every command that reads a case (the file, and changes to it), and the report at the end of a run or a
// study.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "input/language/parse.hpp"

namespace talus::app {

struct CaseOptions {
  std::string file;
  std::vector<std::string> sets;  ///< key=value

  /// Adds CASE and --set to a command; the options must outlive the parsing of the command line.
  void add_to(const Command& command);
  /// Throws Error (wrong_input) for a change that is not key=value.
  std::vector<input::Override> parse_overrides() const;
};

/// Runs `work`, then writes `folder`/report.html, also if the work threw after it had begun, unless it was
/// interrupted; the report then has the partial results. Rethrows the exception of the work; a failure of the report
/// is an error only if the work succeeded.
void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work);

}  // namespace talus::app
