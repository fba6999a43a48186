// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/leg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/ranks.hpp"
#include "base/user_file.hpp"
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
  const auto checkpoint =
      context.resume ? open_checkpoint(files.folder / settings.checkpoint_name, context.input_hash) : nullptr;
  auto [recorder, stage, first] = begin_recording(settings, body, checkpoint.get());
  std::vector<results::Trial> results;
  for (int i = 0; i < static_cast<int>(legs.size()); ++i) {
    const StagePlan<D>& leg = legs[static_cast<std::size_t>(i)];
    const auto leg_folder = files.folder / ("leg_" + std::to_string(i));
    if (i < first) {  // finished before the interruption
      if (const auto done = load_trial(leg_folder)) results.push_back(*done);
      continue;
    }
    if (i > first) stage = {};
    const StageHooks<D> hooks = recorder.begin_leg(i, leg, body, stage);
    results.push_back(run_trial(body, factor, leg, stage, hooks));
    if (context.progress)
      context.progress->show(fmt::format("{}{}: moved {:.4g} m", files.label, leg.name, results.back().displacement),
                             {.method = "mpm",
                              .series = i == 0 ? "displacement curve" : "runout",
                              .factor = factor,
                              .displacement = results.back().displacement});
    const bool last = i + 1 == static_cast<int>(legs.size());
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

namespace {

namespace fs = std::filesystem;

/// Writes the files of a folder into a message, with their paths relative to it.
void put_files(Message& message, const fs::path& folder) {
  std::vector<fs::path> files;
  if (!folder.empty() && fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  message.put(files.size());
  for (const fs::path& file : files) {
    message.put_text(fs::relative(file, folder).string());
    message.put_text(read_user_file(file, largest_file::any));
  }
}
void get_files(Message& message, const fs::path& folder) {
  for (auto left = message.get<std::size_t>(); left > 0; --left) {
    const fs::path file = join_path(folder, message.get_text());
    make_folder(file.parent_path());
    write_atomically(file, message.get_text());
  }
}

/// The trials of one group of ranks: outcomes and files of the finished ones, and the failure that prevented the
/// others.
struct GroupWork {
  int done = 0;
  Failure failure{ExitCode::success, ""};
  Message outcomes, files;
};

GroupWork run_group(int first, int stride, int count, const std::function<results::TrialOutcome(int)>& work,
                    const std::function<fs::path(int)>& folder) {
  GroupWork mine;
  const bool leads = get_ranks().rank() == 0;
  try {
    for (int i = first; i < count; i += stride) {
      const results::TrialOutcome outcome = work(i);
      if (!leads) continue;
      mine.outcomes.put_text(results::to_json(outcome).dump());
      put_files(mine.files, folder ? folder(i) : fs::path());
      ++mine.done;
    }
  } catch (...) {
    mine.failure = explain_failure(std::current_exception());
  }
  return mine;
}

}  // namespace

int count_parallel_trials(int points, int threads) {
  constexpr int points_worth_threads = 200000;
  return points < points_worth_threads ? std::max(threads, get_ranks().size()) : 1;
}

std::vector<results::TrialOutcome> run_side_by_side(int count, int side_by_side,
                                                    const std::function<results::TrialOutcome(int)>& work,
                                                    const std::function<fs::path(int)>& folder) {
  std::vector<results::TrialOutcome> found(static_cast<std::size_t>(count));
  Ranks& ranks = get_ranks();
  const int groups = std::min({count, side_by_side, ranks.size()});
  if (groups <= 1 || ranks.size() == 1) {
    parallel_tasks(count, ranks.size() == 1 ? side_by_side : 1,
                   [&](int i) { found[static_cast<std::size_t>(i)] = work(i); });
    return found;
  }
  GroupWork mine;
  bool leads = false;
  {
    const RankGroup group(groups);
    leads = get_ranks().rank() == 0;
    mine = run_group(group.number(), groups, count, work, folder);
  }
  Message result;
  result.put(mine.done);
  result.put(leads);
  result.put(mine.failure.code);
  result.put_text(mine.failure.sentence);
  result.put(mine.outcomes.bytes().data(), mine.outcomes.bytes().size());
  std::vector<Bytes> all = ranks.gather(result.bytes(), true), files = ranks.gather(mine.files.bytes(), false);
  int number = 0;
  Failure first{ExitCode::success, ""};
  for (std::size_t r = 0; r < all.size(); ++r) {
    Message message(std::move(all[r]));
    const int done = message.get<int>();
    const bool of_leader = message.get<bool>();
    const Failure failure{message.get<ExitCode>(), message.get_text()};
    if (first.code == ExitCode::success) first = failure;
    if (!of_leader) continue;
    Message of_group = files.empty() ? Message() : Message(std::move(files[r]));
    for (int i = number; i < number + done * groups; i += groups) {
      found[static_cast<std::size_t>(i)] =
          results::from_json<results::TrialOutcome>(nlohmann::json::parse(message.get_text()), "a trial's outcome");
      if (ranks.rank() == 0 && r > 0 && folder) get_files(of_group, folder(i));
    }
    ++number;
  }
  if (first.code != ExitCode::success)
    throw Error(first.code, first.sentence);  // the files of finished trials are kept
  return found;
}

}  // namespace talus::run
