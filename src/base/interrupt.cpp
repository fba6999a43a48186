// SPDX-License-Identifier: MIT
#include "base/interrupt.hpp"

#include <csignal>

#include <atomic>

#include "base/error.hpp"

namespace talus {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<void (*)()> watcher{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void handle(int signal) {
  if (interrupted.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, handle);
  std::signal(SIGTERM, handle);
}

bool is_interrupted() {
  if (void (*look)() = watcher.load(std::memory_order_relaxed)) look();
  return interrupted.load(std::memory_order_relaxed);
}

void throw_if_interrupted() {
  if (is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted; what was calculated is saved, --resume goes on from there");
}

void request_interrupt(bool wanted) {
  interrupted.store(wanted);
}

void watch_interrupts(void (*look)()) {
  watcher.store(look);
}

}  // namespace talus
