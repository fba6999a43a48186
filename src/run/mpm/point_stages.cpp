// SPDX-License-Identifier: MIT
#include "run/mpm/point_stages.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/atomic_file.hpp"
#include "mpm/solver/observe.hpp"
#include "results/json.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/stage/stage_warnings.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

using Clock = std::chrono::steady_clock;

/// An unbalanced force above this fraction of gravity at the end of a timed stage gives a warning.
constexpr double restless_force_ratio = 0.01;

}  // namespace

template <int D>
RecorderSettings PointStages<D>::make_settings() const {
  RecorderSettings settings;
  settings.folder = options_.folder;
  settings.input_hash = points_.checkpoint_hash;
  settings.data = &data_;
  settings.work_before = points_.work_before;
  if (data_.analysis == input::AnalysisKind::run) settings.runout_start = &points_.runout_start;
  settings.frame_interval = data_.output.frame_interval;
  settings.progress = options_.progress;
  settings.label = options_.label;
  return settings;
}

template <int D>
void PointStages<D>::run() {
  RecordedRun<D> recorded = begin_recording(make_settings(), points_.body, points_.checkpoint.get());
  if (points_.checkpoint) load(recorded.first);
  for (int i = recorded.first; i < static_cast<int>(data_.stages.size()); ++i) {
    run_one(i, recorded.state, recorded.recorder);
    recorded.state = {};
  }
  monitor_points_ = recorded.recorder.monitor_points();
  recorded.recorder.finish(false);
}

template <int D>
void PointStages<D>::run_one(int number, StageState& state, Recorder<D>& recorder) {
  mpm::Body<D>& body = points_.body;
  const input::Stage& stage = data_.stages[static_cast<std::size_t>(number)];
  StagePlan<D> plan = make_plan<D>(data_, stage, points_.slope_height, options_.threads);
  plan.helpers = helpers_;
  set_strength(body, data_, plan.cohesion, plan.strength_factor);
  if (!state.started) {
    if (number > 0 || !data_.initial.result.empty()) state.gravity_share = 1;
    if (stage.reset_displacement) mpm::reset_displacements(body);
  }
  warn_before(plan);
  // Before the first stage no soil carries its weight.
  const bool brings_weight = plan.brings_weight && !state.started && body.water.is_wet();
  const std::optional<CarriedWeight> before = brings_weight ? std::optional(find_carried_weight(body)) : std::nullopt;
  const auto start = Clock::now();
  const StageHooks<D> hooks = watch_bands(body, recorder.begin_leg(number, plan, body, state));
  const results::StageEnd end = run_stage(body, plan, state, hooks);
  results::Stage report = make_report(plan, state, end);
  report.wall = std::chrono::duration<double>(Clock::now() - start).count();
  warn_after(stage, report, number + 1 == static_cast<int>(data_.stages.size()));
  const auto warn = [&](std::optional<std::string> sentence) {
    if (sentence) points_.warnings.push_back(std::move(*sentence));
  };
  if (before && plan.until_rest) warn(describe_undrained_weight(body, stage.name, *before, data_.units()));
  if (const auto narrow = describe_narrow_band(body, state, data_.softening_length, data_.units()))
    warn(fmt::format("stage '{}': {}", stage.name, *narrow));
  if (is_equilibrium_stage(data_, number))
    if (const results::Preconsolidation done = set_preconsolidation(body, data_); done.points > 0)
      report.preconsolidation = done;
  stages_.push_back(std::move(report));
  results::write_file(file(), results::StageRecord{stages_, points_.warnings});
  recorder.end_leg(body);
}

template <int D>
results::Stage PointStages<D>::make_report(const StagePlan<D>& plan, const StageState& state,
                                           results::StageEnd end) const {
  const mpm::Body<D>& body = points_.body;
  results::Stage report;
  report.end = end;
  report.name = plan.name;
  report.start = state.start_time;
  report.time = body.time;
  report.steps = state.steps;
  report.time_step = state.dt;
  report.displacement = mpm::find_largest_displacement(body).value;
  report.force_ratio = find_force_ratio(body.monitor);
  report.speed = body.monitor.speed;
  if (plan.until_rest && end != results::StageEnd::rest) report.moving = find_moving_soil(body);
  if (!state.setbacks.empty()) report.setbacks = state.setbacks;
  return report;
}

template <int D>
void PointStages<D>::warn_before(const StagePlan<D>& plan) {
  for (auto& sentence : {describe_slow_wave(points_.body, plan), describe_fast_water(points_.body, plan)})
    if (sentence) points_.warnings.push_back(*sentence);
}

template <int D>
void PointStages<D>::warn_after(const input::Stage& stage, const results::Stage& report, bool is_last) {
  if (report.setbacks)
    for (const results::Retry& setback : *report.setbacks)
      points_.warnings.push_back(describe_setback(fmt::format("stage '{}'", stage.name), setback));
  if (report.moving) {
    points_.warnings.push_back(describe_restless(stage, report, data_.units()));
  } else if (stage.until == input::Until::time && report.force_ratio > restless_force_ratio &&
             (!is_last || data_.analysis == input::AnalysisKind::strength_reduction)) {
    points_.warnings.push_back(fmt::format(
        "stage '{}' ended with an unbalanced force of {:.2g} of gravity; what follows starts from a moving slope",
        stage.name, report.force_ratio));
  }
}

/// Reads the finished stages, which are stored beside the checkpoint, with the warnings so far.
template <int D>
void PointStages<D>::load(int count) {
  auto kept = results::read_file<results::StageRecord>(file());
  if (!kept) return;
  stages_ = std::move(kept->stages);
  points_.warnings = std::move(kept->warnings);
  if (static_cast<int>(stages_.size()) > count) stages_.resize(static_cast<std::size_t>(count));
}

template <int D>
void PointStages<D>::forget() const {
  remove_file(file());
}

template class PointStages<2>;
template class PointStages<3>;

}  // namespace talus::run
