// SPDX-License-Identifier: MIT
// The program `talus`: reads the command line, runs one command, and turns every error into a sentence and an exit
// code.

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "app/command_line.hpp"
#include "app/wait_policy.hpp"
#include "base/abandon.hpp"
#include "base/error.hpp"

namespace {

/// Diagnostics already begin with their place; other errors begin with the program's name.
int report(const talus::Error& error) {
  const bool has_place = dynamic_cast<const talus::InputError*>(&error) != nullptr;
  fmt::print(stderr, "{}{}\n", has_place ? "" : "talus: error: ", error.what());
  return static_cast<int>(error.code());
}

int run(int argc, char** argv) {
  try {
    return talus::app::run_command_line(argc, argv);
  } catch (const talus::Error& error) {
    return report(error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus: internal error: {}; please report it with the case file\n", error.what());
  } catch (...) {
    fmt::print(stderr, "talus: internal error of unknown kind; please report it with the case file\n");
  }
  return static_cast<int>(talus::ExitCode::internal_error);
}

}  // namespace

int main(int argc, char** argv) {
  talus::app::let_waiting_threads_sleep(argv);
  const int code = run(argc, argv);
  if (talus::is_work_abandoned()) {
    std::fflush(nullptr);
    std::_Exit(code);
  }
  return code;
}
