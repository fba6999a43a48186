// SPDX-License-Identifier: MIT
#pragma once
// A process of ours that a test watches.

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace talus::support {

/// Waits until the process catches SIGTERM and has calculated for `seconds` of its own time, or has ended: on a busy
/// machine it may start slowly.
inline void wait_for_work(pid_t child, double seconds) {
  constexpr unsigned long long term = 1ULL << (SIGTERM - 1);
  for (int i = 0; i < 100000; ++i) {
    const std::filesystem::path about = "/proc/" + std::to_string(child);
    std::ifstream stat(about / "stat"), status(about / "status");
    std::string word, state;
    // After the name in brackets: the state, ten numbers, user and system time in ticks.
    for (stat >> word; stat && word.back() != ')';) stat >> word;
    stat >> state;
    if (!stat || state == "Z") return;
    for (int k = 0; k < 10; ++k) stat >> word;
    double user = 0, system = 0;
    stat >> user >> system;
    unsigned long long caught = 0;
    while (status >> word)
      if (word == "SigCgt:") status >> std::hex >> caught;
    if ((caught & term) != 0 && user + system >= seconds * static_cast<double>(sysconf(_SC_CLK_TCK))) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace talus::support
