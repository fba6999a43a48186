// SPDX-License-Identifier: MIT
#pragma once
// Progress of a run as server-sent events, from its lines of progress and the frames that it stores.

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus::studio {

/// Returns the values of a line of `talus run --progress-lines`, with `fraction` where it is known; null for other
/// lines.
nlohmann::json read_progress(const std::string& line);

/// Returns the last line of a log that is no progress, which is the error of the command; empty if there is none.
std::string find_last_sentence(const std::filesystem::path& log);

/// Returns the last line of progress of a log; null if there is none.
nlohmann::json find_last_progress(const std::filesystem::path& log);

/// Appends an event to a stream.
void add_event(std::string& piece, const char* event, const nlohmann::json& data);

/// Follows a run that may be in progress.
class RunFollower {
 public:
  RunFollower(std::filesystem::path log, std::filesystem::path results)
      : log_(std::move(log)), results_(std::move(results)) {}

  /// Appends what is new since the last call:
  ///   value     values of one line: {method, series, lower, upper, factor, holds, displacement, time, done, total,
  ///             surface}, for every factor of a trial or result
  ///   progress  the last line: {line, label, stage, time, duration, fraction, values}
  ///   frame     the newest frame of material points: {time, stage, count, x, y, displacement} in [m] and [s], of at
  ///             most 4,000 points
  void add_news(std::string& piece);

 private:
  void add_lines(std::string& piece);
  void add_frame(std::string& piece);

  std::filesystem::path log_, results_, frame_;
  std::filesystem::file_time_type frame_written_{};
  std::streamoff at_ = 0;
  std::string rest_;  ///< an incomplete line
  std::chrono::steady_clock::time_point next_look_{};
};

}  // namespace talus::studio
