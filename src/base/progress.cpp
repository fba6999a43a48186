// SPDX-License-Identifier: MIT
#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"

namespace talus {

namespace {

std::atomic<bool> interrupted{false};
std::atomic<void (*)()> watcher{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

}  // namespace

bool is_interrupted() {
  if (void (*look)() = watcher.load(std::memory_order_relaxed)) look();
  return interrupted.load(std::memory_order_relaxed);
}

void throw_if_interrupted() {
  if (is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted; what was calculated is saved, --resume continues from there");
}

void request_interrupt(bool wanted) {
  interrupted.store(wanted);
}

void watch_interrupts(void (*look)()) {
  watcher.store(look);
}

namespace {

constexpr std::chrono::milliseconds interval{200};

}  // namespace

Progress::Progress(bool wanted) : wanted_(wanted), enabled_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::Progress(Listener listener) : wanted_(true), enabled_(true), listener_(std::move(listener)) {}

Progress::~Progress() {
  clear();
}

bool Progress::is_due(Clock::time_point now) const {
  return enabled_ && now.time_since_epoch() >= next_.load();
}

void Progress::show(const std::string& line) {
  show(ProgressReport{line, {}, {}, 0, 0});
}

void Progress::show(const std::string& line, ProgressValues values) {
  show(ProgressReport{line, {}, {}, 0, 0, std::move(values)});
}

void Progress::show(const ProgressReport& report) {
  const std::lock_guard lock(mutex_);
  if (!enabled_) return;
  if (listener_) {
    listener_(report);
  } else {
    fmt::print(stderr, "\r\033[K{}", make_printable(report.line));
    std::fflush(stderr);
    shown_ = true;
  }
  next_ = std::chrono::steady_clock::now().time_since_epoch() + interval;
}

void Progress::note(const std::string& sentence) {
  if (listener_) return show(sentence);
  clear();
  const std::lock_guard lock(mutex_);
  if (wanted_) fmt::print(stderr, "{}\n", sentence);
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

std::string format_duration(double seconds) {
  if (!(seconds >= 0)) return "?";
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  const long long whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace talus
