// SPDX-License-Identifier: MIT
// Short commands: `talus manual`, the reference of every key of a case file or of the results; `talus schema`, their
// JSON Schema; `talus template`, a commented case file; `talus version`.
#include "app/command_line.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "base/lane.hpp"
#include "base/version.hpp"
#include "input/read.hpp"
#include "results/json.hpp"

namespace talus::app {

void add_manual(CLI::App& app) {
  const Command command(app, "manual", "Print the reference of every key of a case file (Markdown)");
  const auto of_results = std::make_shared<bool>(false);
  command.flag("--results", *of_results, "Print the reference of summary.json, the results of a run, instead");
  command.act([of_results] { fmt::print("{}", *of_results ? results::write_manual() : input::write_manual()); });
}

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

void add_template(CLI::App& app) {
  Command(app, "template", "Print a commented case file with every key; it can be run as it is").act([] {
    fmt::print("{}", input::write_template());
  });
}

std::string write_version() {
  return fmt::format("talus {} (source {}, {}, {}, {})", version, commit, compiler, build_type,
                     architecture == std::string_view(instruction_level)
                         ? architecture
                         : fmt::format("{}: {}", architecture, instruction_level));
}

void check_asked_level() {
  const char* asked = std::getenv("TALUS_LEVEL");
  if (asked == nullptr || *asked == '\0' || asked == std::string_view(instruction_level)) return;
  fail_input("TALUS_LEVEL is '{}', and this program is compiled for {} alone. Packages have all levels", asked,
             instruction_level);
}

void add_version(CLI::App& app) {
  Command(app, "version", "Print the version, its source revision and its build").act([] {
    fmt::print("{}\n", write_version());
  });
}

}  // namespace talus::app
