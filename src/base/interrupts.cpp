// SPDX-License-Identifier: MIT
// The thread that receives SIGINT and SIGTERM. A library may replace the handlers of the process for a time, as METIS
// does while it orders a matrix: its handler jumps out of METIS, or out of another thread that METIS does not run in.
// So all threads block the two signals, and one thread takes them from the queue, which no handler can prevent.

#include <pthread.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "base/progress.hpp"

namespace talus {

namespace {

std::atomic<bool> has_arrived{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

sigset_t list_signals() {
  sigset_t both;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  return both;
}

/// Also the handler for threads that do not block the signals, such as those of a host of this library.
void note_signal(int signal) {
  request_interrupt();
  if (!has_arrived.exchange(true)) return;
  std::signal(signal, SIG_DFL);
  const sigset_t both = list_signals();
  pthread_sigmask(SIG_UNBLOCK, &both, nullptr);
  std::raise(signal);
}

void wait_for_signals() {
  const sigset_t both = list_signals();
  for (int signal = 0;;)
    if (sigwait(&both, &signal) == 0) note_signal(signal);
}

}  // namespace

void catch_interrupts() {
  static const bool is_first = [] {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
    const sigset_t both = list_signals();
    pthread_sigmask(SIG_BLOCK, &both, nullptr);
    std::thread(wait_for_signals).detach();
    return true;
  }();
  static_cast<void>(is_first);
}

}  // namespace talus
