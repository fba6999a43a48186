#include <fmt/format.h>

#include "app/commands.hpp"
#include "input/read.hpp"

namespace talus::app {

void add_schema(CLI::App& app) {
  app.add_subcommand("schema", "Print the JSON Schema of case files, for editors")->callback([] {
    fmt::print("{}\n", input::write_schema().dump(2));
  });
}

}  // namespace talus::app
