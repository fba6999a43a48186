// SPDX-License-Identifier: MIT
#pragma once
// One line on the terminal that is written over as work goes on; nothing when standard error is no terminal. A program
// that embeds this one receives the progress instead.

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace talus {

// SIGINT and SIGTERM ask for an orderly end: the calculation looks here between steps, saves itself and stops.

/// From now on both signals set the flag instead of ending the program; a second one ends it at once.
void catch_interrupts();

/// Whether one of them has arrived.
bool is_interrupted();

/// Throws Error (interrupted) when one has arrived, for work that keeps its results as it goes on.
void throw_if_interrupted();

/// Sets the flag as the signal does, for tests and for programs that embed this one; false clears it.
void request_interrupt(bool wanted = true);

/// Calls `look` wherever the calculation looks for signals, for tests of how often it does; nullptr ends it.
void watch_interrupts(void (*look)());

/// How far a calculation is: the line for a person, and the same as values.
struct ProgressReport {
  std::string line;
  std::string label;    ///< which of several, "[3 of 24] "; empty for the stages of a case
  std::string stage;    ///< name of the stage or trial; empty where there is only a line
  double time = 0;      ///< simulated time since its start [s]
  double duration = 0;  ///< its whole time, or the longest that it may take to rest [s]; 0: not known
};

class Progress {
 public:
  using Listener = std::function<void(const ProgressReport&)>;

  /// Shows something only when standard error is a terminal and `wanted`.
  explicit Progress(bool wanted = true);
  /// Tells `listener` instead, from the threads that calculate, one at a time; it must be quick and must not throw.
  explicit Progress(Listener listener);
  ~Progress();

  using Clock = std::chrono::steady_clock;
  /// Whether a new line would be shown at `now`; lines come at most five times a second. Cheap, so ask before
  /// composing.
  bool is_due(Clock::time_point now = Clock::now()) const;
  /// Replaces the line. Safe to call from several threads.
  void show(const std::string& line);
  void show(const ProgressReport& report);
  /// Prints a sentence that stays, wherever standard error goes.
  void note(const std::string& sentence);
  /// Removes the line, so that other output starts on a clean one.
  void clear();

 private:
  bool wanted_, enabled_;
  Listener listener_;
  bool shown_ = false;
  std::atomic<Clock::duration> next_{};  ///< earliest time of the next line
  std::mutex mutex_;
};

/// 75 s as "1 min 15 s".
std::string format_duration(double seconds);

}  // namespace talus
