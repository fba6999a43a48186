// SPDX-License-Identifier: MIT
#include "run/mpm/point_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "results/json.hpp"
#include "run/common/head.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/record/point_results.hpp"
#include "run/mpm/record/sections.hpp"
#include "run/mpm/reduction/strength_reduction.hpp"
#include "run/mpm/start/bars.hpp"
#include "run/mpm/start/body_archive.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/mpm/start/prepare.hpp"
#include "site/roots.hpp"

namespace talus::run {

namespace fs = std::filesystem;

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
    : loaded_(loaded),
      data_(data),
      options_(options),
      hash_(std::move(input_hash)),
      stages_(data, options, points_, shares_stages(data) ? &helpers_ : nullptr) {}

template <int D>
void PointRun<D>::prepare(results::RunResult& run) {
  const auto make = [&] { points_ = prepare_points<D>(loaded_, data_, options_, hash_, run); };
  shares_stages(data_) ? lead_ranks(make) : make();
}

/// Writes what the report needs before the first step: the elements, the sides named by the boundaries, and the
/// season.
template <int D>
void PointRun<D>::open() {
  if (helps(data_)) return;
  output::ArchiveWriter archive;
  put_mesh(archive, points_.body.mesh());
  archive.write(options_.folder / "mesh.h5");
  if (points_.season) site::write_season(options_.folder / "season.csv", *points_.season);
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
                             points_.checkpoint_hash,
                             &data_,
                             options_.progress,
                             options_.resume,
                             stages_.monitor_points(),
                             [this](const mpm::Timing& timing) {
                               const std::lock_guard lock(adding_);
                               trial_timing_ += timing;
                             },
                             points_.work_before};
  reduce_strength<D>(points_.body, context, points_.slope_height, options_.threads, run, points_.warnings);
}

/// Runs the stages, and sets their results. The end state is that from which another case can start.
template <int D>
void PointRun<D>::run_stages(results::RunResult& run) {
  stages_.run();
  const mpm::Body<D>& body = points_.body;
  save_end_state(options_.folder, loaded_.echo, points_.mesh_input, hash_, body, site::write_root_input(data_));
  run.budgets = make_budgets_result<D>(body, find_gravity<D>(data_.gravity), points_.work_before);
  if (!body.bars.empty()) run.supports = make_bar_results(body, data_);
  if (body.water.is_wet()) run.water = make_water_result<D>(data_, body, points_.initial_water);
  if (data_.analysis != input::AnalysisKind::run) return;
  run.runout = find_runout(body, points_.runout_start);
  if (std::string limits = describe_limits(*run.runout); !limits.empty()) points_.warnings.push_back(std::move(limits));
  run.failure_time = find_failure_time(options_.folder / "history.csv",
                                       data_.strength_reduction.curve.displacement_ratio * points_.slope_height);
  write_profiles(options_.folder / "profile.csv", points_.runout_start.initial,
                 find_profile(body, points_.profile_bin));
}

template <int D>
void PointRun<D>::finish(results::RunResult& run) {
  if (helps(data_)) return;
  const auto& lost = points_.body.lost;
  if (!lost.empty()) {
    double mass = 0;
    for (const auto& l : lost) mass += l.mass;
    points_.warnings.push_back(fmt::format(
        "{} points with {:.1f} kg left the grid (the first at t = {:.4g} s); enlarge the box if they matter",
        lost.size(), mass, lost.front().time));
  }
  run.stages = stages_.list();
  if (Ranks& ranks = get_ranks(); ranks.size() > 1) {
    const Traffic& traffic = ranks.traffic();
    run.ranks = {ranks.size(), traffic.bytes, traffic.seconds, traffic.hand_overs};
  }
  try {
    read_output(run, data_, options_.folder);
  } catch (const Error& error) {
    points_.warnings.push_back(error.what());  // a table that cannot be written must not prevent the summary
  }
  run.warnings = points_.warnings;
}

template <int D>
std::vector<results::TimedPart> PointRun<D>::list_parts(double cpu) const {
  std::vector<results::TimedPart> parts;
  double known = 0;
  const auto add = [&](const char* name, const char* title, double seconds) {
    if (seconds > 0) parts.push_back({name, title, seconds});
    if (seconds > 0) known += seconds;
  };
  mpm::Timing steps = points_.body.timing;
  steps += trial_timing_;
  add("preparation", "mesh and material points", points_.seconds);
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
  return make_seconds_result(points_.body.timing);
}

template <int D>
void PointRun<D>::forget() {
  stages_.forget();
  remove_file(options_.folder / "checkpoint.h5");
}

template <int D>
results::RunResult run_points_beside(const input::LoadedCase& loaded, const RunOptions& options,
                                     const std::string& input_hash, const MakePointCase& make_case,
                                     const std::function<void(results::RunResult&)>& complete) {
  auto finished = load_finished(options, input_hash);
  bool is_finished = finished.has_value();
  broadcast(is_finished);
  if (is_finished) return finished ? std::move(*finished) : results::RunResult();
  results::RunResult run = begin_result(loaded, input_hash, options.threads);
  make_folder(options.folder);
  PointRun<D> points(loaded, make_case(run), options, input_hash);
  points.prepare(run);
  points.open();
  points.calculate(run);
  points.finish(run);
  complete(run);
  run.status = results::Status::finished;
  results::write_file(options.folder / "summary.json", run);
  points.forget();
  return run;
}

#define TALUS_INSTANTIATE(D)                                                                                        \
  template class PointRun<D>;                                                                                       \
  template results::RunResult run_points_beside<D>(const input::LoadedCase&, const RunOptions&, const std::string&, \
                                                   const MakePointCase&,                                            \
                                                   const std::function<void(results::RunResult&)>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
