// SPDX-License-Identifier: MIT
#pragma once
// What every command that reads a case takes: the file, and changes to it.

#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "input/language/overrides.hpp"

namespace talus::app {

struct CaseOptions {
  std::string file;
  std::vector<std::string> sets;  ///< key=value

  /// Adds CASE and --set to a command; the options must live as long as the command line is parsed.
  void add_to(const Command& command);
  /// The changes. Throws Error (wrong_input) for one that is not key=value.
  std::vector<input::Override> parse_overrides() const;
};

}  // namespace talus::app
