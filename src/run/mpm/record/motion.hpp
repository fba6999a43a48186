// SPDX-License-Identifier: MIT
#pragma once
// Onset, order and displacement of the monitored points of a run, and its time of failure.

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

/// Returns the time at which the clock of onset and sections starts ([output] count_from), or nullopt if the run did
/// not reach that stage. `stages`: the stages reached.
std::optional<results::Clock> find_clock(const input::Case& data, const std::vector<results::Stage>& stages);

/// Displacement of a monitor by row, relative to the start of the clock.
struct MonitorPath {
  std::vector<double> time, displacement;  ///< [s] on the clock, [m]
};
/// Reads the path of a monitor from a table such as monitors.csv. If displacements are not set to zero at the start of
/// the clock, the displacement of the row there is subtracted.
MonitorPath read_monitor_path(const output::HistoryTable& table, const std::string& monitor,
                              const results::Clock& clock);

/// Returns the time at which `displacement` first exceeds `threshold`, by linear interpolation between rows; nullopt
/// if it never does. `time` ascends; a NaN (the point has left the grid) ends the search.
std::optional<double> find_onset(std::span<const double> time, std::span<const double> displacement, double threshold);

/// Speed over the mean speed until then, below which a movement has come to rest.
inline constexpr double rest_share = 0.05;

/// Onset of the movement of a monitor.
struct MovementOnset {
  std::optional<double> time;     ///< [s]; nullopt if it did not move, or came to rest and did not move again
  std::optional<double> settled;  ///< displacement reached by an earlier movement that had come to rest [m]
};

/// Returns the onset: the time at which `displacement` exceeds `threshold`, unless it comes to rest afterwards while it
/// is below `failure` [m], the displacement of a slide. That movement is a settlement, as of soil whose holding
/// strength is taken away; then the onset is the time at which the displacement exceeds the largest one until the last
/// rest by `threshold`, or reaches `failure`. At rest the speed is below rest_share of its mean until then. Between
/// rows everything is linear; a NaN ends the search.
MovementOnset find_movement_onset(std::span<const double> time, std::span<const double> displacement, double threshold,
                                  double failure);

/// Displacement above which a monitor, or soil in a runout, counts as moved [m].
double find_onset_threshold(const input::Output& output, double slope_height);

/// A monitor with its onset [s], if it moved, and its initial height [m].
struct MonitorOnset {
  std::string name;
  double height = 0;
  std::optional<double> onset;
  std::optional<double> settled = {};  ///< as in MovementOnset [m]
};

/// Classifies the order of the onsets. `together`: the first and the last differ by at most `together_share` of the
/// last. Upwards (a retrogressive slide) and downwards: each monitor moves after the one below or above it. `single`:
/// only one moved. `mixed` otherwise.
inline constexpr double together_share = 0.1;
results::MotionPattern find_pattern(const std::vector<MonitorOnset>& monitors);

/// Evaluates monitors.csv in `folder`: clock, threshold, onset and displacement of each monitor, order, pattern, and a
/// sentence that states them with the criterion. Returns nullopt without monitors or clock.
std::optional<results::Motion> find_motion(const input::Case& data, const std::vector<results::Stage>& stages,
                                           double slope_height, const std::filesystem::path& folder);

/// Returns the time of failure [s], at which the largest displacement in `history` (a history.csv) exceeded
/// `displacement` [m] for the last time, by linear interpolation between rows. Displacements may be set to zero
/// between stages, so earlier crossings do not count. Returns nullopt if it ended below, was never below, or the file
/// does not exist.
std::optional<double> find_failure_time(const std::filesystem::path& history, double displacement);

}  // namespace talus::run
