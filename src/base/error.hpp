// SPDX-License-Identifier: MIT
#pragma once
// What can go wrong, as one sentence for the person at the keyboard and one exit code for the shell.

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace talus {

/// Exit codes of the program, listed in docs/manual/command-line.md.
enum class ExitCode : int {
  success = 0,
  internal_error = 1,  ///< a defect of the program itself
  wrong_input = 2,     ///< the case file or the command line is wrong; nothing was written
  folder_exists = 3,   ///< the result folder exists and --overwrite was not given; nothing was written
  unstable = 4,        ///< the calculation became unstable; the last good state of the stage or trial is saved
  interrupted = 5,     ///< SIGINT or SIGTERM; a checkpoint is saved and --resume continues
  cannot_write = 6,    ///< the disk is full or the folder is not writable; what was written before is whole
  no_memory = 7,       ///< the machine has not enough memory, or starts no more processes; what was written is whole
};

/// An error that is the user's to read: one sentence that says what, where and what was expected.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// One fault of a case file. `line` and `column` count from 1; 0 means that the fault has no place in the file.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string sentence;
  bool is_unknown_key = false;  ///< no case has a key of that name
};

/// All faults of a case file, found in one run.
class InputError : public Error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// What ended some work, for the person at the keyboard.
struct Failure {
  ExitCode code = ExitCode::internal_error;
  std::string sentence;
};

/// What an exception means, whatever it is. An Error means what it says. What the machine refuses has the code of that:
/// memory (no_memory), a disk (cannot_write), a file or folder that may not be looked at (wrong_input). All others are
/// defects of the program, and the sentence asks for a report.
Failure explain_failure(const std::exception_ptr& thrown);

/// `file:line:column: error: sentence`, without the place where there is none.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace talus
