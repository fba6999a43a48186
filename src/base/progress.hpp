// SPDX-License-Identifier: MIT
#pragma once
// Handling of SIGINT and SIGTERM, and progress on the terminal: one line that is overwritten, or calls of a listener in
// a program that embeds this one.

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace talus {

// SIGINT and SIGTERM request an orderly end: the calculation checks for them between steps, writes a checkpoint and
// stops.

/// Starts a thread that sets a flag at a signal; a second one ends the program at once. The calling thread, and those
/// that it starts later, block the two signals (base/interrupts.cpp).
void catch_interrupts();

/// Returns true if one of the signals has arrived.
bool is_interrupted();

/// Throws Error (interrupted) if one has arrived, for work whose results so far are already written.
void throw_if_interrupted();

/// Sets the flag as the signal does, for tests and for embedding programs; false clears it.
void request_interrupt(bool wanted = true);

/// Calls `look` at every check for signals, for tests of their frequency; nullptr ends it.
void watch_interrupts(void (*look)());

/// Values that a calculation has found so far, for programs that draw them. Those without a value are unknown.
struct ProgressValues {
  std::string method{};                    ///< word of the method, such as "fem"; empty: there are no values
  std::string series{};                    ///< distinguishes curves of one method, such as flow rules
  std::optional<double> lower{}, upper{};  ///< ends of the factor of safety so far
  std::optional<double> factor{};          ///< of a trial, or a result
  std::optional<bool> holds{};             ///< equilibrium in the trial at `factor`; nullopt: `factor` is a result
  std::optional<double> displacement{};    ///< of the trial, or largest so far [m]
  std::optional<double> time{};            ///< at which `factor` holds [s]
  int done = 0, total = 0;                 ///< of equal parts; total = 0: unknown
  std::vector<std::array<double, 2>> surface{};  ///< slip surface of `factor` [m]
};

/// Progress of a calculation, as a line for the terminal and as values.
struct ProgressReport {
  std::string line;
  std::string label;    ///< position among several calculations, "[3 of 24] "; empty for the stages of a case
  std::string stage;    ///< name of the stage or trial; empty if there is only a line
  double time = 0;      ///< simulated time since its start [s]
  double duration = 0;  ///< total time, or the longest time to rest [s]; 0: unknown
  ProgressValues values{};
};

class Progress {
 public:
  using Listener = std::function<void(const ProgressReport&)>;

  /// Writes only if standard error is a terminal and `wanted`.
  explicit Progress(bool wanted = true);
  /// Calls `listener` instead, from the calculating threads, one at a time; it must be fast and must not throw.
  explicit Progress(Listener listener);
  ~Progress();

  using Clock = std::chrono::steady_clock;
  /// Returns true if a new line would be written at `now`, at most five times per second. This is cheap; call it before
  /// composing a line.
  bool is_due(Clock::time_point now = Clock::now()) const;
  /// Replaces the line. Thread-safe.
  void show(const std::string& line);
  void show(const std::string& line, ProgressValues values);
  void show(const ProgressReport& report);
  /// Writes a permanent sentence to standard error, also if it is not a terminal.
  void note(const std::string& sentence);
  /// Erases the line before other output.
  void clear();

 private:
  bool wanted_, enabled_;
  Listener listener_;
  bool shown_ = false;
  std::atomic<Clock::duration> next_{};  ///< earliest time of the next line
  std::mutex mutex_;
};

/// Formats 75 s as "1 min 15 s".
std::string format_duration(double seconds);

}  // namespace talus
