// SPDX-License-Identifier: MIT
#include "report/content/run_sequences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file_name.hpp"
#include "report/content/sequence.hpp"

namespace talus::report {
namespace {

SequencePlan plan_stages(const std::shared_ptr<const output::ResultsReader>& frames, std::string id,
                         std::string title) {
  SequencePlan plan{SequenceKind::stages, std::move(id), std::move(title), {}};
  if (!frames) return plan;
  for (int i = 0; i < frames->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    plan.frames.push_back(
        {frames, i, std::nullopt, fmt::format("{}, t = {:.3g} s", frames->stages()[k], frames->times()[k])});
  }
  return plan;
}

/// The stages of the run, and those of the material points that a timeline released earlier and later.
std::vector<SequencePlan> plan_all_stages(const ResultFolder& folder) {
  std::vector<SequencePlan> plans;
  if (!folder.run.timeline || folder.run.timeline->releases.empty())
    plans.push_back(plan_stages(folder.frames, "stages", "Stages"));
  else
    for (const results::Release& r : folder.run.timeline->releases)
      plans.push_back(plan_stages(r.folder.empty() ? folder.frames : open_frames(join_name(folder.path, r.folder)),
                                  r.folder.empty() ? "stages" : r.folder,
                                  "Released at " + results::format_moment(*folder.run.timeline, r.time)));
  std::erase_if(plans, [](const SequencePlan& plan) { return plan.frames.empty(); });
  return plans;
}

/// The last frame of the trial itself, before it runs out.
int find_end_of_trial(const output::ResultsReader& frames) {
  int last = 0;
  for (int i = 0; i < frames.size(); ++i)
    if (!frames.stages()[static_cast<std::size_t>(i)].starts_with("runout")) last = i;
  return last;
}

std::vector<SequencePlan> plan_trials(const ResultFolder& folder) {
  SequencePlan curve{SequenceKind::curve, "curve", "Trials of the displacement curve", {}};
  std::vector<SequencePlan> plans;
  for (const TrialFolder& trial : folder.trials) {
    const auto frames = open_frames(trial.path);
    if (!frames || frames->size() == 0) continue;
    if (!trial.runs_out || frames->size() > 1)
      curve.frames.push_back({frames, find_end_of_trial(*frames), trial.factor, fmt::format("SRF {:g}", trial.factor)});
    if (!trial.runs_out) continue;
    SequencePlan runout{SequenceKind::runout,
                        fmt::format("runout_{:g}", trial.factor),
                        fmt::format("Runout at SRF {:g}", trial.factor),
                        {}};
    for (int i = 0; i < frames->size(); ++i)
      runout.frames.push_back(
          {frames, i, trial.factor, fmt::format("t = {:.3g} s", frames->times()[static_cast<std::size_t>(i)])});
    plans.push_back(std::move(runout));
  }
  if (!curve.frames.empty()) plans.insert(plans.begin(), std::move(curve));
  return plans;
}

}  // namespace

nlohmann::json pack_sequences(const ResultFolder& folder, Packer& packer) {
  std::vector<SequencePlan> plans = plan_all_stages(folder);
  for (SequencePlan& plan : plan_trials(folder)) plans.push_back(std::move(plan));
  nlohmann::json sequences = nlohmann::json::array();
  // Where all soil has left the grid there is nothing to look at.
  std::erase_if(plans, [](const SequencePlan& plan) {
    const SequenceFrame& start = plan.frames.front();
    return start.reader->read(start.index).point_count() == 0;
  });
  if (plans.empty()) return sequences;
  // All sequences begin with the points of the same body.
  const SequenceFrame& first = plans[0].frames[0];
  const std::size_t points = static_cast<std::size_t>(first.reader->read(first.index).point_count());
  Budget budget;
  std::vector<std::size_t> needs;
  for (const SequencePlan& plan : plans) needs.push_back(points * std::min(plan.frames.size(), budget.frames));
  const std::vector<std::size_t> shares = share_out(needs, find_most_point_frames(get_dimension(folder.run)));
  const ShownUnits units = read_units(folder.run);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    budget.point_frames = shares[k];
    sequences.push_back(pack_sequence(plans[k], get_dimension(folder.run), units, budget, packer));
  }
  return sequences;
}

}  // namespace talus::report
