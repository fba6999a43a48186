#include "run/mpm/reduction/leg.hpp"

#include <fstream>

#include "base/atomic_file.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::run {
namespace {

const char* to_word(StageEnd end) {
  switch (end) {
    case StageEnd::rest:
      return "rest";
    case StageEnd::failed:
      return "failed";
    case StageEnd::time:
      return "time";
  }
  return "time";
}

StageEnd end_from_word(const std::string& word) {
  return word == "rest" ? StageEnd::rest : (word == "failed" ? StageEnd::failed : StageEnd::time);
}

}  // namespace

nlohmann::json to_json(const TrialResult& t) {
  return {{"srf", t.factor},
          {"end", to_word(t.end)},
          {"displacement", t.displacement},
          {"time", t.time},
          {"steps", t.steps},
          {"force_ratio", t.force_ratio},
          {"nodal_speed", t.speed},
          {"largest_nodal_speed", t.largest_speed}};
}

TrialResult trial_from_json(const nlohmann::json& j) {
  TrialResult t;
  t.factor = j.at("srf");
  t.end = end_from_word(j.at("end"));
  t.displacement = j.at("displacement");
  t.time = j.at("time");
  t.steps = j.at("steps");
  t.force_ratio = j.at("force_ratio");
  t.speed = j.at("nodal_speed");
  t.largest_speed = j.at("largest_nodal_speed");
  return t;
}

std::optional<TrialResult> load_trial(const std::filesystem::path& folder) {
  std::ifstream file(folder / "trial.json");
  if (!file) return std::nullopt;
  return trial_from_json(nlohmann::json::parse(file));
}

KnownTrials load_trials(const std::filesystem::path& path) {
  KnownTrials known;
  std::ifstream file(path);
  if (!file) return known;
  for (const auto& j : nlohmann::json::parse(file)) {
    const TrialResult t = trial_from_json(j);
    known[t.factor] = t;
  }
  return known;
}

void save_trials(const std::filesystem::path& path, const std::vector<TrialResult>& trials) {
  nlohmann::json list = nlohmann::json::array();
  for (const TrialResult& t : trials) list.push_back(to_json(t));
  make_folder(path.parent_path());
  write_atomically(path, list.dump(2) + "\n");
}

void save_trial(const std::filesystem::path& folder, const TrialResult& trial) {
  make_folder(folder);
  write_atomically(folder / "trial.json", to_json(trial).dump(2) + "\n");
}

template <int D>
std::vector<TrialResult> run_trial_legs(const mpm::Body<D>& state, double factor, const std::vector<StagePlan<D>>& legs,
                                        const TrialContext& context, const TrialFiles& files, mpm::Body<D>& body) {
  RecorderSettings settings;
  settings.folder = files.folder;
  settings.input_hash = context.input_hash;
  settings.data = context.data;
  settings.keeps_history = files.keeps_history;
  settings.keeps_frames = files.keeps_frames;
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
  std::vector<TrialResult> results;
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

template std::vector<TrialResult> run_trial_legs<2>(const mpm::Body<2>&, double, const std::vector<StagePlan<2>>&,
                                                    const TrialContext&, const TrialFiles&, mpm::Body<2>&);
template std::vector<TrialResult> run_trial_legs<3>(const mpm::Body<3>&, double, const std::vector<StagePlan<3>>&,
                                                    const TrialContext&, const TrialFiles&, mpm::Body<3>&);

}  // namespace talus::run
