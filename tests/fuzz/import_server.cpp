// SPDX-License-Identifier: MIT
// Imports the files that standard input names, each in a process of its own that is forked after all libraries are
// loaded: a hundredth of the time of `talus import`. Prints a line for each: exit code or −signal, processor time [ms],
// memory [MB], message. Used by mutate_drawings.py.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "drawing/import.hpp"

namespace {

constexpr rlim_t longest_import = 100;  // of processor time [s]

int import_file(const std::string& file, const std::string& output) {
  try {
    const auto found = talus::drawing::import_files({{file}, "m", "", "", "", "", "", {}, {}});
    std::ofstream(output) << found.text;
    return 0;
  } catch (...) {
    const talus::Failure failure = talus::explain_failure(std::current_exception());
    std::ofstream(output) << failure.sentence;
    return static_cast<int>(failure.code);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::string output = arguments[1];
  if (!talus::drawing::has_gdal()) std::puts("no GDAL");
  for (std::string file; std::getline(std::cin, file);) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      const rlimit time{longest_import, longest_import};
      setrlimit(RLIMIT_CPU, &time);
      _exit(import_file(file, output));
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    std::string message;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
      std::ifstream text(output);
      message.assign(std::istreambuf_iterator<char>(text), {});
      for (char& c : message)
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    const double ms = 1e3 * static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                      1e-3 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    std::printf("%d\t%.0f\t%ld\t%s\n", WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), ms,
                usage.ru_maxrss / 1000, message.c_str());
    std::fflush(stdout);
  }
  return 0;
}
