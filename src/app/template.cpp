// SPDX-License-Identifier: MIT
// `talus template`: a commented case file that can be run as it is.

#include <fmt/format.h>

#include "app/commands.hpp"
#include "input/read.hpp"

namespace talus::app {

void add_template(CLI::App& app) {
  Command(app, "template", "Print a commented case file with every key; it can be run as it is").act([] {
    fmt::print("{}", input::write_template());
  });
}

}  // namespace talus::app
