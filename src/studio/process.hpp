// SPDX-License-Identifier: MIT
#pragma once
// Child processes of the studio: the program itself with a list of arguments, without a shell.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::studio {

/// Files to which a process appends its outputs; without `err` both go into `out`.
struct ProcessFiles {
  std::filesystem::path out, err;
};

/// Starts `program` with `arguments`, the first of which is its own name, in a group of processes of its own. Returns
/// the number of the process, or 0 with the reason in `why`.
int start_process(const std::filesystem::path& program, std::vector<std::string> arguments, const ProcessFiles& outputs,
                  std::string& why);

/// Waits for a child for at most `seconds`, and then kills it with its own children. Returns its exit status, -1 if it
/// crashed, and nothing if it was killed.
std::optional<int> wait_for_process(int process, double seconds);

/// Returns the time at which a process started, in the words of the system; empty if there is none. It identifies a
/// process of an earlier server.
std::string find_process_start(int process);

/// Runs the program and waits for its end. Throws Refusal with the last line of its output if it fails, and (504) if it
/// takes longer than `seconds`.
void run_process(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& log, double seconds);

/// Returns the end of a file, at most `most` bytes; empty if it is no regular file.
std::string read_tail(const std::filesystem::path& file, std::streamoff most);

/// Returns what a growing file has behind the byte `at`, at most its last `most` bytes, and moves `at` behind it.
std::string read_news(const std::filesystem::path& file, std::streamoff most, std::streamoff& at);

std::vector<std::string> split_lines(const std::string& text);

}  // namespace talus::studio
