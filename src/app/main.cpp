// SPDX-License-Identifier: MIT
// The program `talus`: reads the command line, runs one command, and turns every error into a sentence and an exit
// code.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/wait_policy.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace {

/// CLI11 would only say that a command is required.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = talus::find_nearest(argv[1], names);
  throw talus::Error(talus::ExitCode::wrong_input,
                     fmt::format("there is no command '{}'; {}", argv[1],
                                 near.empty() ? "see talus --help" : fmt::format("did you mean '{}'?", near)));
}

int run_command_line(int argc, char** argv) {
  CLI::App app{"Talus: slope stability and runout by the material point method", "talus"};
  app.require_subcommand(1);
  app.footer("`talus COMMAND --help` explains a command; `talus manual` lists every key of a case file.");
  using namespace talus::app;
  for (const auto add : {add_run, add_study, add_collect, add_point, add_calibrate, add_plot, add_report, add_check,
                         add_manual, add_template, add_schema, add_version})
    add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help is an "error" with code 0 here; every other one is a mistake in the command line.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    refuse_unknown_command(app, argc, argv);
    const auto used = app.get_subcommands();
    const std::string command = used.empty() ? "" : " " + used.front()->get_name();
    throw talus::Error(talus::ExitCode::wrong_input, fmt::format("{}; see talus{} --help", error.what(), command));
  }
  return static_cast<int>(talus::ExitCode::success);
}

/// Diagnostics already begin with their place; other errors begin with the program's name.
int report(const talus::Error& error) {
  const bool has_place = dynamic_cast<const talus::InputError*>(&error) != nullptr;
  fmt::print(stderr, "{}{}\n", has_place ? "" : "talus: error: ", error.what());
  return static_cast<int>(error.code());
}

}  // namespace

int main(int argc, char** argv) {
  talus::app::let_waiting_threads_sleep(argv);
  try {
    return run_command_line(argc, argv);
  } catch (const talus::Error& error) {
    return report(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus: internal error: {}; please report it with the case file\n", error.what());
  } catch (...) {
    fmt::print(stderr, "talus: internal error of unknown kind; please report it with the case file\n");
  }
  return static_cast<int>(talus::ExitCode::internal_error);
}
