// SPDX-License-Identifier: MIT
// The program `talus`: reads the command line, runs one command, and converts every error into a message and an exit
// code.

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>

#include "app/command_line.hpp"
#include "app/wait_policy.hpp"
#include "base/error.hpp"
#include "base/ranks.hpp"
#include "base/text.hpp"

namespace {

/// Returns true for diagnostics, which begin with their place; other errors begin with the name of the program.
bool has_place(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const talus::InputError&) {
    return true;
  } catch (...) {
    return false;
  }
}

/// Time within which the other ranks must report the same failure [s].
constexpr double patience = 10;

int report(const std::exception_ptr& thrown) {
  const talus::Failure failure = talus::explain_failure(thrown);
  talus::Ranks& ranks = talus::get_ranks();
  const bool is_common = ranks.meet(patience);
  if (is_common && ranks.rank() > 0) return static_cast<int>(failure.code);
  const std::string sentence = fmt::format("{}{}\n", has_place(thrown) ? "" : "talus: error: ", failure.sentence);
  talus::print(stderr, sentence);
  if (!is_common) ranks.abort(static_cast<int>(failure.code));
  return static_cast<int>(failure.code);
}

int run(int argc, char** argv) try {
  const int code = talus::app::run_command_line(argc, argv);
  // Printed text may still be in a buffer.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw talus::Error(talus::ExitCode::cannot_write, "cannot print: {}", std::strerror(errno));
  talus::get_ranks().meet(std::numeric_limits<double>::infinity());
  return code;
} catch (...) {
  return report(std::current_exception());
}

}  // namespace

int main(int argc, char** argv) {
  talus::app::let_waiting_threads_sleep(argv);
  // A limit on the size of a file then gives an error message, as a full disk does.
  std::signal(SIGXFSZ, SIG_IGN);
  const int code = run(argc, argv);
  talus::leave_ranks();
  return code;
}
