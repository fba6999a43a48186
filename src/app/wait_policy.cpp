// SPDX-License-Identifier: MIT
#include "app/wait_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace talus::app {

bool set_wait_policy() {
  // By default a thread spins while it waits for the slowest one. On a shared machine spinning threads can take the
  // core of the thread they wait for: a run of 3 s then took 200 s.
  constexpr const char* mark =
      "TALUS_WAIT_POLICY_SET";  // prevents repetition, even if the environment loses the other variables
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(mark) != nullptr) return false;
  setenv("OMP_WAIT_POLICY", "passive", 0);
  // A short spin avoids a system call for each of the many small loops of a step.
  setenv("GOMP_SPINCOUNT", "20000", 0);
  setenv(mark, "1", 1);
  return true;
}

void let_waiting_threads_sleep(char** argv) {
  if (set_wait_policy()) execv("/proc/self/exe", argv);  // Linux only; elsewhere execv() fails, and the threads spin
}

}  // namespace talus::app
