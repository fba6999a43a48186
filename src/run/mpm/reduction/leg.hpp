// SPDX-License-Identifier: MIT
#pragma once
// A trial in a folder of its own: it keeps its result, and can be resumed while it runs.

#include <filesystem>
#include <functional>
#include <vector>

#include "results/trial.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/reduction/trial.hpp"

namespace talus::run {

/// What all trials of a case share.
struct TrialContext {
  std::filesystem::path folder;  ///< of the case
  std::string input_hash;
  const input::Case* data = nullptr;
  Progress* progress = nullptr;
  bool resume = false;
  std::vector<int> monitor_points;  ///< those of the stages
  /// Told how long the parts of a trial took; called from any thread.
  std::function<void(const mpm::Timing&)> add_timing = [](const mpm::Timing&) {};
  mpm::Work work_before{};  ///< see RecorderSettings
};

/// The result of a trial that ended in an earlier run, kept as `folder/trial.json`.
std::optional<results::Trial> load_trial(const std::filesystem::path& folder);
void save_trial(const std::filesystem::path& folder, const results::Trial& trial);

/// A list of trials in a file, by factor; nothing when there is no such file.
KnownTrials load_trials(const std::filesystem::path& path);
/// In the order of their factors: that in which they end depends on the number of threads.
void save_trials(const std::filesystem::path& path, std::vector<results::Trial> trials);

struct TrialFiles {
  std::filesystem::path folder;
  bool keeps_frames = false;  ///< the last frame, or one every `frame_interval`
  bool keeps_history = false;
  double frame_interval = 0;
  const RunoutStart* runout_start = nullptr;  ///< for the front in the history
  std::string label;
};

/// Runs one trial from `state` with reduced strength, in legs one after the other; resumes it when the context says so
/// and a checkpoint is there. `body` receives the state at the end. Results of each leg are returned.
template <int D>
std::vector<results::Trial> run_trial_legs(const mpm::Body<D>& state, double factor,
                                           const std::vector<StagePlan<D>>& legs, const TrialContext& context,
                                           const TrialFiles& files, mpm::Body<D>& body);

// Trials that are calculated at the same time: on threads of one process, or on groups of ranks.

/// How many trials of a body of this size run side by side on `threads` threads of a process, or on the ranks; the rest
/// of them work inside the trials. Small bodies gain nothing from threads inside a step.
int count_parallel_trials(int points, int threads);

/// Returns work(i) for i < count, up to `side_by_side` at once. Of several ranks each group calculates a part of them;
/// then all know all outcomes, and rank 0 has in folder(i) the files that were written there.
std::vector<results::TrialOutcome> run_side_by_side(int count, int side_by_side,
                                                    const std::function<results::TrialOutcome(int)>& work,
                                                    const std::function<std::filesystem::path(int)>& folder = {});

}  // namespace talus::run
