// SPDX-License-Identifier: MIT
#pragma once
// A trial in a folder of its own, which can be resumed, and trials that run concurrently on threads of one process or
// on groups of ranks.

#include <filesystem>
#include <functional>
#include <vector>

#include "results/trial.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/reduction/trial.hpp"

namespace talus::run {

/// Settings common to all trials of a case.
struct TrialContext {
  std::filesystem::path folder;  ///< of the case
  std::string input_hash;
  const input::Case* data = nullptr;
  Progress* progress = nullptr;
  bool resume = false;
  std::vector<int> monitor_points;  ///< the same as in the stages
  /// Receives the time of the phases of a trial; called from any thread.
  std::function<void(const mpm::Timing&)> add_timing = [](const mpm::Timing&) {};
  mpm::Work work_before{};  ///< see RecorderSettings
};

/// Reads the result of a trial that ended in an earlier run, `folder/trial.json`; nullopt if there is none.
std::optional<results::Trial> load_trial(const std::filesystem::path& folder);
void save_trial(const std::filesystem::path& folder, const results::Trial& trial);

/// Reads a list of trials from a file, by factor; empty if the file does not exist.
KnownTrials load_trials(const std::filesystem::path& path);
/// Writes the trials in the order of their factors, since the order in which they end depends on the number of
/// threads.
void save_trials(const std::filesystem::path& path, std::vector<results::Trial> trials);

struct TrialFiles {
  std::filesystem::path folder;
  bool keeps_frames = false;  ///< the last frame, or one every `frame_interval`
  bool keeps_history = false;
  double frame_interval = 0;
  const RunoutStart* runout_start = nullptr;  ///< for the front in the history
  std::string label;
};

/// Runs one trial from `state` with reduced strength, in consecutive legs; resumes it when the context requires it and
/// a checkpoint exists. `body` receives the final state. Returns the result of each leg.
template <int D>
std::vector<results::Trial> run_trial_legs(const mpm::Body<D>& state, double factor,
                                           const std::vector<StagePlan<D>>& legs, const TrialContext& context,
                                           const TrialFiles& files, mpm::Body<D>& body);

/// Returns how many trials of a body of this size run concurrently on `threads` threads of a process, or on the ranks;
/// the remaining threads or ranks work inside the trials. Small bodies do not profit from threads inside a step.
int count_parallel_trials(int points, int threads);

/// Returns work(i) for i < count, with up to `side_by_side` at once. With several ranks each group calculates a part
/// of them; afterwards all ranks have all outcomes, and rank 0 has the files written in folder(i).
std::vector<results::TrialOutcome> run_side_by_side(int count, int side_by_side,
                                                    const std::function<results::TrialOutcome(int)>& work,
                                                    const std::function<std::filesystem::path(int)>& folder = {});

}  // namespace talus::run
