// SPDX-License-Identifier: MIT
// `talus version`: the version, its source, and how it was built.

#include "base/version.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/lane.hpp"

namespace talus::app {

std::string write_version() {
  return fmt::format("talus {} (source {}, {}, {}, {})", version, commit, compiler, build_type,
                     architecture == std::string_view(instruction_level)
                         ? architecture
                         : fmt::format("{}: {}", architecture, instruction_level));
}

void check_asked_level() {
  const char* asked = std::getenv("TALUS_LEVEL");
  if (asked == nullptr || *asked == '\0' || asked == std::string_view(instruction_level)) return;
  throw Error(ExitCode::wrong_input,
              fmt::format("TALUS_LEVEL is '{}', and this program is compiled for {} alone. Packages have all levels",
                          asked, instruction_level));
}

void add_version(CLI::App& app) {
  Command(app, "version", "Print the version, its source revision and its build").act([] {
    fmt::print("{}\n", write_version());
  });
}

}  // namespace talus::app
