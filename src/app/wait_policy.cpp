// SPDX-License-Identifier: MIT
#include "app/wait_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace talus::app {

bool set_wait_policy() {
  // By default a thread spins while it waits for the slowest one. On a machine that others use too, the spinning
  // threads take the core from the one they wait for: a run of 3 s then took 200 s.
  constexpr const char* mark = "TALUS_WAIT_POLICY_SET";  // never twice, even if the environment does not keep the rest
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(mark) != nullptr) return false;
  setenv("OMP_WAIT_POLICY", "passive", 0);
  // A short spin keeps the many small loops of a step from paying a system call each.
  setenv("GOMP_SPINCOUNT", "20000", 0);
  setenv(mark, "1", 1);
  return true;
}

void let_waiting_threads_sleep(char** argv) {
  if (set_wait_policy()) execv("/proc/self/exe", argv);  // Linux; elsewhere it fails, and the threads spin
}

}  // namespace talus::app
