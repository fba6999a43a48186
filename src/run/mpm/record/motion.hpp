// SPDX-License-Identifier: MIT
#pragma once
// When the monitored points of a run began to move, in which order, and how far they went.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "output/files/history.hpp"
#include "results/runout.hpp"
#include "results/trial.hpp"

namespace talus::run {

/// Where the clock of onset and sections starts: [output] count_from. `stages`: those that the run reached. Nothing
/// when it did not reach the stage.
std::optional<results::Clock> find_clock(const input::Case& data, const std::vector<results::Stage>& stages);

/// Displacement of a monitor from the start of the clock on, [row], beginning with zero there.
struct MonitorPath {
  std::vector<double> time, displacement;  ///< [s] on the clock, [m]
};
/// From a table as monitors.csv. Where displacements are not set to zero at the start of the clock, they are counted
/// from the row there.
MonitorPath read_monitor_path(const output::HistoryTable& table, const std::string& monitor,
                              const results::Clock& clock);

/// The time at which `displacement` first exceeds `threshold`, by linear interpolation between rows; nothing when it
/// never does. `time` ascends; values that are no numbers (the point has left the grid) end the search.
std::optional<double> find_onset(std::span<const double> time, std::span<const double> displacement, double threshold);

/// What counts as movement in the runs of a case [m]: of monitors, and of the soil that has run out.
double find_onset_threshold(const input::Output& output, double slope_height);

/// A monitor with its onset [s], if it moved, and its height [m] at the start.
struct MonitorOnset {
  std::string name;
  double height = 0;
  std::optional<double> onset;
};

/// How the onsets follow each other. Together: the first and the last are apart by at most `together_share` of the
/// last. Upwards (a retrogressive slide) and downwards: each monitor after the one below or above it. `mixed`
/// otherwise; `single` when only one moved.
inline constexpr double together_share = 0.1;
results::MotionPattern find_pattern(const std::vector<MonitorOnset>& monitors);

/// From monitors.csv in `folder`: clock, threshold, onset and displacement of each monitor, order, pattern and a
/// sentence that says it with its criterion. Nothing when there is no monitor or no clock.
std::optional<results::Motion> find_motion(const input::Case& data, const std::vector<results::Stage>& stages,
                                           double slope_height, const std::filesystem::path& folder);

// When a slope failed: read off the history of its largest displacement.

/// The time [s] at which the largest displacement in `history` (a history.csv) reached `displacement` [m] for the last
/// time, by linear interpolation between rows: displacements may be set to zero between stages, and what happened
/// before does not count. Nothing when it ended below, was never below, or there is no such file.
std::optional<double> find_failure_time(const std::filesystem::path& history, double displacement);

}  // namespace talus::run
