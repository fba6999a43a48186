// SPDX-License-Identifier: MIT
// The program run by a test, and files read as text. Programs of tests define TALUS_PROGRAM, so this is a header only.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace talus::support {

struct Outcome {
  int code = -1;
  std::string text;  ///< both output streams
};

/// Runs a command in a shell.
inline Outcome run_command(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  return outcome;
}

/// Runs `talus` in a shell; `environment` holds assignments such as "PMI_SIZE=4".
inline Outcome run_program(const std::string& arguments, const std::string& environment = "") {
  return run_command(environment + " '" TALUS_PROGRAM "' " + arguments);
}

/// The bytes of a file; empty where it cannot be read.
inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace talus::support
