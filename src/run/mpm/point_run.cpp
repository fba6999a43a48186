// SPDX-License-Identifier: MIT
#include "run/mpm/point_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/memory.hpp"
#include "mesh/generate.hpp"
#include "mesh/quality.hpp"
#include "mpm/solver/observe.hpp"
#include "results/json.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/record/point_results.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/record/sections.hpp"
#include "run/mpm/record/water_record.hpp"
#include "run/mpm/reduction/strength_reduction.hpp"
#include "run/mpm/stage/stage_warnings.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "run/mpm/start/prepare.hpp"
#include "site/roots.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// An unbalanced force above this fraction of gravity at the end of a timed stage gives a warning.
constexpr double restless_force_ratio = 0.01;

double find_seconds(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

double find_process_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void read_output(results::RunResult& run, const input::Case& data, const fs::path& folder) {
  run.clock.reset();
  run.motion.reset();
  run.sections.reset();
  const std::vector<results::Stage> stages = run.stages.value_or(std::vector<results::Stage>{});
  run.clock = find_clock(data, stages);
  auto motion = find_motion(data, stages, run.slope_height.value_or(0), folder);
  if (data.analysis == input::AnalysisKind::run) run.motion = std::move(motion);
  if (auto sections = write_sections(data, stages, run.mesh ? run.mesh->mean_size : 1, folder); !sections.empty())
    run.sections = std::move(sections);
}

template <int D>
PointRun<D>::PointRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                      std::string input_hash)
    : loaded_(loaded), data_(data), options_(options), hash_(std::move(input_hash)), mesh_input_(loaded.echo) {}

template <int D>
void PointRun<D>::prepare(results::RunResult& run) {
  if (shares_stages(data_))
    lead_ranks([&] { prepare_body(run); });
  else
    prepare_body(run);
}

template <int D>
void PointRun<D>::prepare_body(results::RunResult& run) {
  const auto start = Clock::now();
  open_origin();
  if (options_.resume) checkpoint_ = open_checkpoint(options_.folder / "checkpoint.h5", checkpoint_hash_);
  mesh::Mesh<D> mesh = checkpoint_ ? get_mesh<D>(*checkpoint_)
                       : origin_   ? origin_->get_mesh<D>()
                                   : mesh::generate<D>(data_.mesh);
  check_names(mesh);
  std::optional<fem::SeepageResult<D>> seepage;
  body_ = run::prepare<D>(data_, std::move(mesh), 0, &seepage, &season_);
  work_before_ = body_.work;
  if (body_.water.is_wet()) initial_water_ = mpm::find_water_state(body_).mass;
  preparation_ = find_seconds(start);
  slope_height_ = find_slope_height(body_, data_.gravity);
  run.mesh = make_mesh_result(body_);
  run.slope_height = slope_height_;
  water_ = site::make_water_result<D>(data_, body_.mesh(), seepage, season_);
  if (origin_) water_.states.reset(), water_.fields.reset();  // the water of the result replaces them
  site::give(water_, run);
  if (seepage && seepage->undecided > 0)
    warnings_.push_back(
        fmt::format("steady seepage: {} nodes of the ground fit neither a dry nor a wet surface; the "
                    "mesh is coarse for the height of the capillary fringe",
                    seepage->undecided));
  if (origin_) write_origin(*origin_, run);
  origin_.reset();  // frees as much memory as the body takes
  if (const std::vector<std::string> left = list_left_to_processor(data_); !left.empty())
    warnings_.push_back(
        fmt::format("the device does not calculate water with a velocity of its own (water = \"flows\"): the processor "
                    "did the stages {}",
                    fmt::join(left, ", ")));
  if (body_.conditions.constraints.empty())
    warnings_.push_back("no boundary holds the soil; without [[boundary]] it falls out of the box");
  profile_bin_ = mesh::measure_quality(body_.mesh()).mean_size;
  runout_start_ = {find_profile(body_, profile_bin_), find_onset_threshold(data_.output, slope_height_)};
  return_freed_memory();
}

/// Writes what the report needs before the first step: the elements, the sides named by the boundaries, and the
/// season.
template <int D>
void PointRun<D>::open() {
  if (helps(data_)) return;
  output::ArchiveWriter archive;
  put_mesh(archive, body_.mesh());
  archive.write(options_.folder / "mesh.h5");
  if (season_) site::write_season(options_.folder / "season.csv", *season_);
}

template <int D>
void PointRun<D>::calculate(results::RunResult& run) {
  if (helps(data_)) return help_with_stages<D>(data_);
  if (shares_stages(data_)) {
    try {
      run_stages(run);
    } catch (...) {
      try {
        helpers_.dismiss(explain_failure(std::current_exception()));
      } catch (const Error&) {  // the failure of a stage is already known on all ranks
      }
      throw;
    }
    return helpers_.dismiss({ExitCode::success, ""});
  }
  run_stages(run);
  if (data_.analysis != input::AnalysisKind::strength_reduction) return;
  const TrialContext context{options_.folder,
                             checkpoint_hash_,
                             &data_,
                             options_.progress,
                             options_.resume,
                             monitor_points_,
                             [this](const mpm::Timing& timing) {
                               const std::lock_guard lock(adding_);
                               trial_timing_ += timing;
                             },
                             work_before_};
  reduce_strength<D>(body_, context, slope_height_, options_.threads, run, warnings_);
}

template <int D>
void PointRun<D>::finish(results::RunResult& run) {
  if (helps(data_)) return;
  if (!body_.lost.empty()) {
    double mass = 0;
    for (const auto& l : body_.lost) mass += l.mass;
    warnings_.push_back(fmt::format(
        "{} points with {:.1f} kg left the grid (the first at t = {:.4g} s); enlarge the box if they matter",
        body_.lost.size(), mass, body_.lost.front().time));
  }
  run.stages = stages_;
  if (Ranks& ranks = get_ranks(); ranks.size() > 1) {
    const Traffic& traffic = ranks.traffic();
    run.ranks = {ranks.size(), traffic.bytes, traffic.seconds, traffic.hand_overs};
  }
  try {
    read_output(run, data_, options_.folder);
  } catch (const Error& error) {
    warnings_.push_back(error.what());  // a table that cannot be written must not prevent the summary
  }
  run.warnings = warnings_;
}

template <int D>
std::vector<results::TimedPart> PointRun<D>::list_parts(double cpu) const {
  std::vector<results::TimedPart> parts;
  double known = 0;
  const auto add = [&](const char* name, const char* title, double seconds) {
    if (seconds > 0) parts.push_back({name, title, seconds});
    if (seconds > 0) known += seconds;
  };
  mpm::Timing steps = body_.timing;
  steps += trial_timing_;
  add("preparation", "mesh and material points", preparation_);
  add("solve_momentum", "momentum balance at the nodes", steps.solve_momentum);
  add("remap_momentum", "remapping of the momentum", steps.remap_momentum);
  add("smooth_strain", "smoothing of the strain", steps.smooth_strain);
  add("advance_points", "material points: motion, strain, stress", steps.advance_points);
  add("relocate", "points that changed their element", steps.relocate);
  add("device", "steps on the device", steps.device);
  add("transfer", "the body on its way to the device and back", steps.transfer);
  add("other", "loads, time step, rest, meshes of trials, output", cpu - known);
  return parts;
}

template <int D>
results::StepSeconds PointRun<D>::get_stage_seconds() const {
  return make_seconds_result(body_.timing);
}

template <int D>
void PointRun<D>::forget() {
  remove_file(stage_file());
  remove_file(options_.folder / "checkpoint.h5");
}

template <int D>
void PointRun<D>::check_names(const mesh::Mesh<D>& mesh) const {
  std::set<std::string> sides, regions(mesh.region_names.begin(), mesh.region_names.end());
  for (const auto& [name, list] : mesh.sides) sides.insert(name);
  input::check_against_mesh(loaded_, sides, regions);
}

/// Opens the result that the case starts from, if there is one. Throws Error (wrong_input) if it does not fit the
/// case.
template <int D>
void PointRun<D>::open_origin() {
  checkpoint_hash_ = hash_;
  if (data_.initial.result.empty()) return;
  origin_ = std::make_unique<EndState>(data_.initial);
  input::check_against_result(loaded_, origin_->input());
  checkpoint_hash_ = hash_text(hash_ + origin_->hash());
  mesh_input_ = origin_->input();
}

template <int D>
void PointRun<D>::write_origin(const EndState& origin, results::RunResult& run) {
  run.start = origin.tell();
  const std::string result = data_.initial.result;
  if (origin.is_on_another_mesh(loaded_.echo))
    warnings_.push_back(
        fmt::format("[geometry] or [mesh] is not as in the case of the result '{}', and was not used: the mesh is that "
                    "of the result",
                    result));
  for (const std::string& name : origin.list_refilled(body_))
    warnings_.push_back(
        fmt::format("material '{}' holds water otherwise than in the result '{}': pore pressures are those of the "
                    "result, the water in the pores has been changed to fit",
                    name, result));
  if (data_.analysis == input::AnalysisKind::strength_reduction && data_.strength_reduction.frozen.enabled)
    warnings_.push_back(
        fmt::format("the mesh is that of the result '{}', which cannot be halved: the factor of safety is that of one "
                    "mesh and not extrapolated",
                    result));
}

template <int D>
void PointRun<D>::run_stages(results::RunResult& run) {
  RecorderSettings settings;
  settings.folder = options_.folder;
  settings.input_hash = checkpoint_hash_;
  settings.data = &data_;
  settings.work_before = work_before_;
  if (data_.analysis == input::AnalysisKind::run) settings.runout_start = &runout_start_;
  settings.frame_interval = data_.output.frame_interval;
  settings.progress = options_.progress;
  settings.label = options_.label;
  StageState state;
  int first = 0;
  if (checkpoint_) {
    get_body(*checkpoint_, body_);
    state = get_stage(*checkpoint_);
    first = get_leg(*checkpoint_);
    load_stages(first);
  }
  Recorder<D> recorder =
      checkpoint_ ? Recorder<D>::resume(settings, body_, *checkpoint_) : Recorder<D>::start(settings, body_);
  const int count = static_cast<int>(data_.stages.size());
  for (int i = first; i < count; ++i) {
    const input::Stage& stage = data_.stages[i];
    StagePlan<D> plan = make_plan<D>(data_, stage, slope_height_, options_.threads);
    if (shares_stages(data_)) plan.helpers = &helpers_;
    set_strength(body_, data_, plan.cohesion, plan.strength_factor);
    if (!state.started) {
      if (i > 0 || !data_.initial.result.empty()) state.gravity_share = 1;
      if (stage.reset_displacement) mpm::reset_displacements(body_);
    }
    if (const auto slow = describe_slow_wave(body_, plan)) warnings_.push_back(*slow);
    if (const auto fast = describe_fast_water(body_, plan)) warnings_.push_back(*fast);
    // Before the first stage no soil carries its weight.
    const bool brings_weight = i == 0 && !state.started && body_.water.is_wet() && data_.initial.result.empty() &&
                               data_.initial.stress == input::InitialStress::none;
    const std::optional<CarriedWeight> before =
        brings_weight ? std::optional(find_carried_weight(body_)) : std::nullopt;
    const auto start = Clock::now();
    const StageHooks<D> hooks = watch_bands(body_, recorder.begin_leg(i, plan, body_, state));
    results::Stage report;
    report.end = run_stage(body_, plan, state, hooks);
    report.name = stage.name;
    report.start = state.start_time;
    report.time = body_.time;
    report.steps = state.steps;
    report.time_step = state.dt;
    report.displacement = mpm::find_largest_displacement(body_).value;
    report.force_ratio = body_.monitor.external > 0 ? body_.monitor.out_of_balance / body_.monitor.external : 0;
    report.speed = body_.monitor.speed;
    report.wall = find_seconds(start);
    if (plan.until_rest && report.end != results::StageEnd::rest) report.moving = find_moving_soil(body_);
    if (!state.setbacks.empty()) report.setbacks = state.setbacks;
    warn_about(stage, report, i + 1 == count);
    if (const auto undrained = before && plan.until_rest
                                   ? describe_undrained_weight(body_, stage.name, *before, data_.units())
                                   : std::nullopt)
      warnings_.push_back(*undrained);
    if (const auto narrow = describe_narrow_band(body_, state, data_.softening_length, data_.units()))
      warnings_.push_back(fmt::format("stage '{}': {}", stage.name, *narrow));
    if (is_equilibrium_stage(data_, i))
      if (const results::Preconsolidation done = set_preconsolidation(body_, data_); done.points > 0)
        report.preconsolidation = done;
    stages_.push_back(std::move(report));
    save_stages();
    recorder.end_leg(body_);
    state = {};
  }
  monitor_points_ = recorder.monitor_points();
  end_stages(run);
  recorder.finish(false);
  if (data_.analysis == input::AnalysisKind::run) add_runout(run);
}

template <int D>
void PointRun<D>::warn_about(const input::Stage& stage, const results::Stage& report, bool last) {
  if (report.setbacks)
    for (const results::Retry& setback : *report.setbacks)
      warnings_.push_back(describe_setback(fmt::format("stage '{}'", stage.name), setback));
  if (report.moving) {
    warnings_.push_back(describe_restless(stage, report, data_.units()));
  } else if (stage.until == input::Until::time && report.force_ratio > restless_force_ratio &&
             (!last || data_.analysis == input::AnalysisKind::strength_reduction)) {
    warnings_.push_back(fmt::format(
        "stage '{}' ended with an unbalanced force of {:.2g} of gravity; what follows starts from a moving slope",
        stage.name, report.force_ratio));
  }
}

/// Sets the results of the stages alone, and writes the end state from which another case can start.
template <int D>
void PointRun<D>::end_stages(results::RunResult& run) {
  save_end_state(options_.folder, loaded_.echo, mesh_input_, hash_, body_, site::write_root_input(data_));
  run.budgets = make_budgets_result<D>(body_, find_gravity<D>(data_.gravity), work_before_);
  if (body_.water.is_wet()) run.water = make_water_result<D>(data_, body_, initial_water_);
}

template <int D>
void PointRun<D>::add_runout(results::RunResult& run) {
  run.runout = find_runout(body_, runout_start_);
  if (std::string limits = describe_limits(*run.runout); !limits.empty()) warnings_.push_back(std::move(limits));
  run.failure_time = find_failure_time(options_.folder / "history.csv",
                                       data_.strength_reduction.curve.displacement_ratio * slope_height_);
  write_profiles(options_.folder / "profile.csv", runout_start_.initial, find_profile(body_, profile_bin_));
}

/// Stores the finished stages beside the checkpoint, from which a resumed run reads them.
template <int D>
void PointRun<D>::save_stages() const {
  results::write_file(stage_file(), results::StageRecord{stages_, warnings_});
}

template <int D>
void PointRun<D>::load_stages(int count) {
  auto kept = results::read_file<results::StageRecord>(stage_file());
  if (!kept) return;
  stages_ = std::move(kept->stages);
  warnings_ = std::move(kept->warnings);
  if (static_cast<int>(stages_.size()) > count) stages_.resize(static_cast<std::size_t>(count));
}

template class PointRun<2>;
template class PointRun<3>;

}  // namespace talus::run
