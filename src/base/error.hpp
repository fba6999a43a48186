// SPDX-License-Identifier: MIT
#pragma once
// Errors of the program: one sentence for the user and one exit code for the shell.

#include <fmt/core.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace talus {

/// Exit codes of the program, listed in docs/manual/command-line.md.
enum class ExitCode : int {
  success = 0,
  internal_error = 1,  ///< a defect of the program itself
  wrong_input = 2,     ///< the case file or the command line is wrong; nothing was written
  folder_exists = 3,   ///< the result folder exists and --overwrite was not given; nothing was written
  unstable = 4,        ///< the calculation became unstable; the last valid state of the stage or trial is saved
  interrupted = 5,     ///< SIGINT or SIGTERM; a checkpoint is saved and --resume continues
  cannot_write = 6,    ///< the disk is full or the folder is not writable; files written before are complete
  no_memory = 7,       ///< not enough memory, or no more processes can be started; files written before are complete
};

/// An error for the user: one sentence with the fault, its place and what was expected.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  /// Formats the sentence as fmt::format() does.
  template <class First, class... Rest>
  Error(ExitCode code, fmt::format_string<First, Rest...> sentence, First&& first, Rest&&... rest)
      : Error(code, fmt::format(sentence, std::forward<First>(first), std::forward<Rest>(rest)...)) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Throws an Error of wrong input.
[[noreturn]] inline void fail_input(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}
template <class... Values>
[[noreturn]] void fail_input(fmt::format_string<Values...> sentence, Values&&... values) {
  throw Error(ExitCode::wrong_input, fmt::format(sentence, std::forward<Values>(values)...));
}

/// One fault of a case file. `line` and `column` count from 1; 0: without a place in the file.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string sentence;
  bool is_unknown_key = false;  ///< the key does not exist in any case
};

/// All faults of a case file, collected in one reading.
class InputError : public Error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// The reason why work ended, as exit code and sentence for the user.
struct Failure {
  ExitCode code = ExitCode::internal_error;
  std::string sentence;
};

/// Converts any exception to a Failure. An Error keeps its code and sentence. Failures of the system have the codes of
/// memory (no_memory), disk (cannot_write), or a file or folder without access (wrong_input). All others are defects of
/// the program, and the sentence asks the user for a report.
Failure explain_failure(const std::exception_ptr& thrown);

/// Writes `file:line:column: error: sentence`, without the place if there is none.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace talus
