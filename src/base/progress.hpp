#pragma once
// One line on the terminal that is written over as work goes on; nothing when standard error is no terminal.

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace talus {

class Progress {
 public:
  /// Shows something only when standard error is a terminal and `wanted`.
  explicit Progress(bool wanted = true);
  ~Progress();

  /// Whether a new line would be shown now; lines come at most five times a second. Cheap, so ask before composing.
  bool is_due() const;
  /// Replaces the line. Safe to call from several threads.
  void show(const std::string& line);
  /// Removes the line, so that other output starts on a clean one.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::atomic<std::chrono::steady_clock::duration> next_{};  ///< earliest time of the next line
  std::mutex mutex_;
};

/// 75 s as "1 min 15 s".
std::string format_duration(double seconds);

}  // namespace talus
