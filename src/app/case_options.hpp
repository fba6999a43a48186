// SPDX-License-Identifier: MIT
#pragma once
// What every command that reads a case takes: the file, and changes to it.

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

  /// Adds CASE and --set to a command; the options must live as long as the command line is parsed.
  void add_to(const Command& command);
  /// The changes. Throws Error (wrong_input) for one that is not key=value.
  std::vector<input::Override> parse_overrides() const;
};

// The report at the end of a run or a study.

/// Does `work`, then writes `folder`/report.html, also when the work threw after it had begun, unless it was
/// interrupted: the report then says how far it came. The exception of the work is thrown again; a report that cannot
/// be written is an error only when the work succeeded.
void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work);

}  // namespace talus::app
