// SPDX-License-Identifier: MIT
// `talus schema`: the JSON Schema of case files, or of the results.

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "input/read.hpp"
#include "results/documents.hpp"

namespace talus::app {

void add_schema(CLI::App& app) {
  const Command command(app, "schema", "Print the JSON Schema of case files, for editors");
  const auto of_results = std::make_shared<bool>(false);
  command.flag("--results", *of_results, "Print the schema of summary.json, the results of a run, instead");
  command.act([of_results] {
    if (*of_results)
      fmt::print("{}", results::write_schema());
    else
      fmt::print("{}\n", input::write_schema().dump(2));
  });
}

}  // namespace talus::app
