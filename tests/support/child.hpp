// SPDX-License-Identifier: MIT
#pragma once
// A child process that a test observes. Nothing depends on wall-clock time, so that a busy machine only slows the test
// down.

#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace talus::support {

/// Waits until the file is there, or the process has ended; whether it is there.
inline bool wait_for_file(const std::filesystem::path& path, pid_t process) {
  const std::filesystem::path folder = path.parent_path();
  if (!std::filesystem::exists(folder) && !wait_for_file(folder, process)) return false;
  const int changes = inotify_init1(IN_CLOEXEC);
  inotify_add_watch(changes, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  const int end = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  std::array<pollfd, 2> events{{{changes, POLLIN, 0}, {end, POLLIN, 0}}};
  while (end >= 0 && !std::filesystem::exists(path) && events[1].revents == 0) {
    poll(events.data(), events.size(), -1);
    std::array<char, 4096> summary;
    if (events[0].revents != 0 && ::read(changes, summary.data(), summary.size()) < 0) break;
  }
  close(changes);
  close(end);
  return std::filesystem::exists(path);
}

/// Returns whether the process runs and has not installed its handler of SIGTERM yet.
inline bool is_starting(pid_t child) {
  constexpr unsigned long long term = 1ULL << (SIGTERM - 1);
  std::ifstream status("/proc/" + std::to_string(child) + "/status");
  std::string word, state = "Z";
  unsigned long long caught = 0;
  while (status >> word) {
    if (word == "State:") status >> state;
    if (word == "SigCgt:") status >> std::hex >> caught;
  }
  return state != "Z" && (caught & term) == 0;
}

/// Waits until the process has calculated for `seconds` of its own time; whether it still runs.
inline bool wait_for_seconds(pid_t child, double seconds) {
  clockid_t clock{};
  const int end = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  if (end < 0 || clock_getcpuclockid(child, &clock) != 0) return false;
  // A timer on the clock of the process sends a signal, which is read like a file.
  sigset_t ours, before;
  sigemptyset(&ours);
  sigaddset(&ours, SIGRTMIN);
  pthread_sigmask(SIG_BLOCK, &ours, &before);
  const int reached = signalfd(-1, &ours, SFD_CLOEXEC | SFD_NONBLOCK);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGRTMIN;
  timer_t timer{};
  timer_create(clock, &event, &timer);
  const double whole = std::floor(seconds);
  const itimerspec at{{0, 0}, {static_cast<time_t>(whole), static_cast<long>(1e9 * (seconds - whole))}};
  timer_settime(timer, TIMER_ABSTIME, &at, nullptr);
  std::array<pollfd, 2> events{{{reached, POLLIN, 0}, {end, POLLIN, 0}}};
  poll(events.data(), events.size(), -1);
  timer_delete(timer);
  signalfd_siginfo summary;  // taken before the mask goes, else the signal would end the test
  [[maybe_unused]] const ssize_t size = read(reached, &summary, sizeof summary);
  close(reached);
  close(end);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return events[1].revents == 0;
}

/// Waits for a child of the process and gives its number; -1 when the process ends without one.
inline pid_t find_child(pid_t process) {
  const std::string name = std::to_string(process), list = "/proc/" + name + "/task/" + name + "/children";
  while (kill(process, 0) == 0) {
    std::ifstream children(list);
    pid_t child = -1;
    if (children >> child) return child;
    std::string word, state = "Z";
    std::ifstream status("/proc/" + name + "/status");
    while (status >> word)
      if (word == "State:") status >> state;
    if (state == "Z") break;
    sched_yield();
  }
  return -1;
}

/// Waits until the process catches SIGTERM and has calculated for `seconds` of its own time, or has ended.
inline void wait_for_work(pid_t child, double seconds) {
  constexpr double more = 0.01;  // of the process's time between two looks [s]
  while (wait_for_seconds(child, seconds) && is_starting(child)) seconds += more;
}

}  // namespace talus::support
