// SPDX-License-Identifier: MIT
// `talus version`: the version, its source, and how it was built.

#include "base/version.hpp"

#include <fmt/format.h>

#include "app/commands.hpp"

namespace talus::app {

std::string write_version() {
  return fmt::format("talus {} (source {}, {}, {}, {})", version, commit, compiler, build_type, architecture);
}

void add_version(CLI::App& app) {
  Command(app, "version", "Print the version, the source it was built from, and how").act([] {
    fmt::print("{}\n", write_version());
  });
}

}  // namespace talus::app
