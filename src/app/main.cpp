// SPDX-License-Identifier: MIT
// The program `talus`: reads the command line, runs one command, and turns every error into a sentence and an exit
// code.

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>

#include "app/command_line.hpp"
#include "app/wait_policy.hpp"
#include "base/error.hpp"

namespace {

/// Diagnostics already begin with their place; other errors begin with the program's name.
bool has_place(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const talus::InputError&) {
    return true;
  } catch (...) {
    return false;
  }
}

int report(const std::exception_ptr& thrown) {
  const talus::Failure failure = talus::explain_failure(thrown);
  const std::string sentence = fmt::format("{}{}\n", has_place(thrown) ? "" : "talus: error: ", failure.sentence);
  std::fputs(sentence.c_str(), stderr);
  return static_cast<int>(failure.code);
}

int run(int argc, char** argv) try {
  const int code = talus::app::run_command_line(argc, argv);
  // What was printed may still wait in memory.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw talus::Error(talus::ExitCode::cannot_write, fmt::format("cannot print: {}", std::strerror(errno)));
  return code;
} catch (...) {
  return report(std::current_exception());
}

}  // namespace

int main(int argc, char** argv) {
  talus::app::let_waiting_threads_sleep(argv);
  // A file that may grow no further is a sentence, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  return run(argc, argv);
}
