// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/leg.hpp"

#include <algorithm>

#include "base/atomic_file.hpp"
#include "results/json.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::run {

std::optional<results::Trial> load_trial(const std::filesystem::path& folder) {
  return results::read_file<results::Trial>(folder / "trial.json");
}

KnownTrials load_trials(const std::filesystem::path& path) {
  KnownTrials known;
  for (const results::Trial& t :
       results::read_file<std::vector<results::Trial>>(path).value_or(std::vector<results::Trial>{}))
    known[t.factor] = t;
  return known;
}

void save_trials(const std::filesystem::path& path, std::vector<results::Trial> trials) {
  std::ranges::sort(trials, {}, &results::Trial::factor);
  make_folder(path.parent_path());
  results::write_file(path, trials);
}

void save_trial(const std::filesystem::path& folder, const results::Trial& trial) {
  make_folder(folder);
  results::write_file(folder / "trial.json", trial);
}

template <int D>
std::vector<results::Trial> run_trial_legs(const mpm::Body<D>& state, double factor,
                                           const std::vector<StagePlan<D>>& legs, const TrialContext& context,
                                           const TrialFiles& files, mpm::Body<D>& body) {
  RecorderSettings settings;
  settings.folder = files.folder;
  settings.input_hash = context.input_hash;
  settings.data = context.data;
  settings.keeps_history = files.keeps_history;
  settings.keeps_frames = files.keeps_frames;
  settings.runout_start = files.runout_start;
  settings.frame_interval = files.frame_interval;
  settings.progress = context.progress;
  settings.label = files.label;
  settings.monitor_points = context.monitor_points;
  settings.work_before = context.work_before;

  body = start_trial(state, *context.data, factor);
  StageState stage;
  std::size_t first = 0;
  const auto checkpoint =
      context.resume ? open_checkpoint(files.folder / settings.checkpoint_name, context.input_hash) : nullptr;
  if (checkpoint) {
    get_body(*checkpoint, body);
    stage = get_stage(*checkpoint);
    first = static_cast<std::size_t>(get_leg(*checkpoint));
  }
  Recorder<D> recorder =
      checkpoint ? Recorder<D>::resume(settings, body, *checkpoint) : Recorder<D>::start(settings, body);
  std::vector<results::Trial> results;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const auto leg_folder = files.folder / ("leg_" + std::to_string(i));
    if (i < first) {  // ended before the interruption
      if (const auto done = load_trial(leg_folder)) results.push_back(*done);
      continue;
    }
    if (i > first || !checkpoint) stage = {};
    const StageHooks<D> hooks = recorder.begin_leg(static_cast<int>(i), legs[i], body, stage);
    results.push_back(run_trial(body, factor, legs[i], stage, hooks));
    const bool last = i + 1 == legs.size();
    if (!last) save_trial(leg_folder, results.back());
    recorder.end_leg(body, !last);
  }
  recorder.finish(true);
  context.add_timing(body.timing);
  return results;
}

template std::vector<results::Trial> run_trial_legs<2>(const mpm::Body<2>&, double, const std::vector<StagePlan<2>>&,
                                                       const TrialContext&, const TrialFiles&, mpm::Body<2>&);
template std::vector<results::Trial> run_trial_legs<3>(const mpm::Body<3>&, double, const std::vector<StagePlan<3>>&,
                                                       const TrialContext&, const TrialFiles&, mpm::Body<3>&);

}  // namespace talus::run
