// SPDX-License-Identifier: MIT
// `talus manual`: the reference of every key of a case file, or of the results.

#include <fmt/format.h>

#include <memory>

#include "app/commands.hpp"
#include "input/read.hpp"
#include "results/documents.hpp"

namespace talus::app {

void add_manual(CLI::App& app) {
  const Command command(app, "manual", "Print the reference of every key of a case file (Markdown)");
  const auto of_results = std::make_shared<bool>(false);
  command.flag("--results", *of_results, "Print the reference of summary.json, the results of a run, instead");
  command.act([of_results] { fmt::print("{}", *of_results ? results::write_manual() : input::write_manual()); });
}

}  // namespace talus::app
