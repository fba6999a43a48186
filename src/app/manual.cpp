#include <fmt/format.h>

#include "app/commands.hpp"
#include "input/read.hpp"

namespace talus::app {

void add_manual(CLI::App& app) {
  app.add_subcommand("manual", "Print the reference of every key of a case file (Markdown)")->callback([] {
    fmt::print("{}", input::write_manual());
  });
}

}  // namespace talus::app
