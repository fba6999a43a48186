// SPDX-License-Identifier: MIT
// `talus version`: the version, its source, and how it was built.

#include "base/version.hpp"

#include <fmt/format.h>

#include "app/commands.hpp"

namespace talus::app {

void add_version(CLI::App& app) {
  Command(app, "version", "Print the version, the source it was built from, and how").act([] {
    fmt::print("talus {} (source {}, {}, {}, {})\n", version, commit, compiler, build_type, architecture);
  });
}

}  // namespace talus::app
