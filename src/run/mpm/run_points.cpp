#include "run/mpm/run_points.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "ground/root_content.hpp"
#include "mesh/generate.hpp"
#include "mpm/body/observe.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/record/onset.hpp"
#include "run/mpm/record/sections.hpp"
#include "run/mpm/record/water_record.hpp"
#include "run/mpm/reduction/strength_reduction.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/mpm/start/initial_state.hpp"
#include "run/mpm/start/prepare.hpp"
#include "run/mpm/water_summary.hpp"
#include "run/named_results.hpp"
#include "run/run_folder.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Unbalanced forces above this share of gravity at the end of a timed stage deserve a warning.
constexpr double restless_force_ratio = 0.01;

double process_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// What follows from the histories and frames that a run has written: onset of movement, sections.
void describe_output(json& summary, const input::Case& data, const fs::path& folder) {
  for (const char* key : {"clock", "motion", "sections"}) summary.erase(key);
  const json stages = summary.value("stages", json::array());
  const double size = summary.at("mesh").value("mean_size", 1.0);
  if (const auto clock = find_clock(data, stages))
    summary["clock"] = {{"stage", clock->stage},
                        {"start", clock->start},
                        {"resets", clock->resets},
                        {"shown_times", data.output.shown_times}};
  if (json motion = describe_motion(data, stages, summary.value("slope_height", 0.0), folder);
      !motion.is_null() && data.analysis == input::AnalysisKind::run)
    summary["motion"] = std::move(motion);
  if (json sections = write_sections(data, stages, size, folder); !sections.empty())
    summary["sections"] = std::move(sections);
}

/// What a finished run compares with, what is read off its results, and its title block, may have changed since: none
/// needs the run again.
void renew_finished(json& summary, const input::Case& data, const fs::path& folder) {
  const json before = summary;
  summary["title"] = data.title;
  summary["project"] = describe_project(data);
  describe_output(summary, data, folder);
  summary["results"] = list_results(data, summary);
  summary["comparisons"] = compare_results(data, summary);
  if (summary != before) write_atomically(folder / "summary.json", summary.dump(2) + "\n");
}

template <int D>
class CaseRun {
 public:
  CaseRun(const input::LoadedCase& loaded, const RunOptions& options, std::string input_hash)
      : loaded_(loaded), data_(loaded.data), options_(options), hash_(std::move(input_hash)) {}

  json run() {
    const auto start = std::chrono::steady_clock::now();
    const double cpu_start = process_seconds();
    std::unique_ptr<EndState> origin = open_origin();
    const auto checkpoint =
        options_.resume ? open_checkpoint(options_.folder / "checkpoint.h5", checkpoint_hash_) : nullptr;
    mesh::Mesh<D> mesh = checkpoint ? get_mesh<D>(*checkpoint)
                         : origin   ? origin->get_mesh<D>()
                                    : mesh::generate<D>(data_.mesh);
    check_names(mesh);
    std::optional<fem::SeepageResult<D>> seepage;
    std::optional<ground::SeasonRecord> season;
    body_ = prepare<D>(data_, std::move(mesh), 0, &seepage, &season);
    work_before_ = body_.work;
    if (body_.water.is_wet()) initial_water_ = find_water_state(body_).mass;
    preparation_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slope_height_ = find_slope_height(body_, data_.gravity);
    fill_summary_head();
    if (seepage) summary_["seepage"] = describe_seepage<D>(body_.mesh(), *seepage);
    if (seepage && seepage->undecided > 0)
      warnings_.push_back(
          fmt::format("steady seepage: {} nodes of the ground fit neither a dry nor a wet surface; the "
                      "mesh is coarse for the height of the capillary fringe",
                      seepage->undecided));
    if (season) summary_["season"] = ground::describe_season(*season);
    if (origin) describe_origin(*origin);
    origin.reset();  // it is as large as the body
    if (body_.conditions.constraints.empty())
      warnings_.push_back("no boundary holds the soil; without [[boundary]] it falls out of the box");
    profile_bin_ = mesh::measure_quality(body_.mesh()).mean_size;
    initial_ = find_profile(body_, profile_bin_);

    clear_folder(options_);
    make_folder(options_.folder);
    keep_mesh();
    if (season) ground::write_season(options_.folder / "season.csv", *season);
    try {
      if (options_.begin) options_.begin(summary_);
      run_stages(checkpoint.get());
      if (data_.analysis == input::AnalysisKind::strength_reduction) {
        const TrialContext context{options_.folder,
                                   checkpoint_hash_,
                                   &data_,
                                   options_.progress,
                                   options_.resume,
                                   monitor_points_,
                                   [this](const mpm::Timing& timing) { add_trial_timing(timing); },
                                   work_before_};
        reduce_strength<D>(body_, context, slope_height_, options_.threads, summary_, warnings_);
        fs::remove(options_.folder / "checkpoint.h5");
      }
      summary_["status"] = "finished";
    } catch (const Error& error) {
      if (options_.progress) options_.progress->clear();
      summary_["status"] = error.code() == ExitCode::interrupted
                               ? "interrupted"
                               : (error.code() == ExitCode::unstable ? "unstable" : "failed");
      summary_["error"] = error.what();
      // A disk that is full for the results is full for this too; the first error is the one to report.
      try {
        finish_summary(start, cpu_start);
      } catch (const Error&) {
      }
      throw;
    }
    if (options_.progress) options_.progress->clear();
    finish_summary(start, cpu_start);
    return summary_;
  }

 private:
  void check_names(const mesh::Mesh<D>& mesh) const {
    std::set<std::string> sides, regions(mesh.region_names.begin(), mesh.region_names.end());
    for (const auto& [name, list] : mesh.sides) sides.insert(name);
    input::check_against_mesh(loaded_, sides, regions);
  }

  /// The result that the case starts from, when there is one, and it fits.
  std::unique_ptr<EndState> open_origin() {
    checkpoint_hash_ = hash_;
    if (data_.initial.result.empty()) return nullptr;
    auto origin = std::make_unique<EndState>(data_.initial);
    input::check_against_result(loaded_, origin->input());
    checkpoint_hash_ = hash_text(hash_ + origin->hash());
    mesh_input_ = origin->input();
    return origin;
  }

  void describe_origin(const EndState& origin) {
    summary_["start"] = origin.describe();
    const std::string result = data_.initial.result;
    if (origin.is_on_another_mesh(loaded_.echo.get()))
      warnings_.push_back(fmt::format(
          "[geometry] or [mesh] is not as in the case of the result '{}', and was not used: the mesh is that "
          "of the result",
          result));
    for (const std::string& name : origin.list_refilled(body_))
      warnings_.push_back(
          fmt::format("material '{}' holds water otherwise than in the result '{}': pore pressures are those of the "
                      "result, the water in the pores has been changed to fit",
                      name, result));
    if (data_.analysis == input::AnalysisKind::strength_reduction && data_.strength_reduction.frozen.enabled)
      warnings_.push_back(fmt::format(
          "the mesh is that of the result '{}', which cannot be halved: the factor of safety is that of one "
          "mesh and not extrapolated",
          result));
  }

  /// The end of the stages for whoever starts from it, and what they did without what was done before them.
  void end_stages() {
    save_end_state(options_.folder, loaded_.echo.get(), mesh_input_, hash_, body_, ground::write_root_input(data_));
    json& budgets = summary_["budgets"] = describe_budgets<D>(body_, find_gravity<D>(data_.gravity));
    budgets["plastic_work"] = body_.work.dissipated - work_before_.dissipated;
    budgets["damping_work"] = body_.work.damped - work_before_.damped;
    budgets["external_work"] = body_.work.external - work_before_.external;
    if (body_.water.is_wet()) summary_["water"] = describe_water<D>(data_, body_, initial_water_);
  }

  void fill_summary_head() {
    summary_.update(describe_case(loaded_, hash_, options_.threads));
    summary_["mesh"] = describe_mesh(body_);
    summary_["slope_height"] = slope_height_;
  }

  /// For the report: the elements and the sides that the boundaries name.
  void keep_mesh() const {
    output::ArchiveWriter archive;
    put_mesh(archive, body_.mesh());
    archive.write(options_.folder / "mesh.h5");
  }

  void run_stages(const output::ArchiveReader* checkpoint) {
    RecorderSettings settings;
    settings.folder = options_.folder;
    settings.input_hash = checkpoint_hash_;
    settings.data = &data_;
    settings.work_before = work_before_;
    settings.frame_interval = data_.output.frame_interval;
    settings.progress = options_.progress;
    StageState state;
    int first = 0;
    if (checkpoint) {
      get_body(*checkpoint, body_);
      state = get_stage(*checkpoint);
      first = get_leg(*checkpoint);
      load_stage_reports(first);
    }
    Recorder<D> recorder =
        checkpoint ? Recorder<D>::resume(settings, body_, *checkpoint) : Recorder<D>::start(settings, body_);
    const int count = static_cast<int>(data_.stages.size());
    for (int i = first; i < count; ++i) {
      const input::Stage& stage = data_.stages[i];
      const StagePlan<D> plan = make_plan<D>(data_, stage, slope_height_, options_.threads);
      set_strength(body_, data_, stage.cohesion, stage.strength_factor.value_or(1));
      if (!state.started) {
        if (i > 0 || !data_.initial.result.empty()) state.gravity_share = 1;
        if (stage.reset_displacement) mpm::reset_displacements(body_);
      }
      const auto start = std::chrono::steady_clock::now();
      const StageHooks<D> hooks = recorder.begin_leg(i, plan, body_, state);
      StageReport report;
      report.end = run_stage(body_, plan, state, hooks);
      report.name = stage.name;
      report.start = state.start_time;
      report.time = body_.time;
      report.steps = state.steps;
      report.time_step = state.dt;
      report.displacement = mpm::find_largest_displacement(body_).value;
      report.force_ratio = body_.monitor.external > 0 ? body_.monitor.out_of_balance / body_.monitor.external : 0;
      report.speed = body_.monitor.speed;
      report.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      warn_about(stage, report, i + 1 == count);
      stages_.push_back(to_json(report));
      if (is_equilibrium_stage(data_, i)) {
        if (const Preconsolidation done = set_preconsolidation(body_, data_); done.points > 0)
          stages_.back()["preconsolidation"] = to_json(done);
      }
      save_stage_reports();
      recorder.end_leg(body_);
      state = {};
    }
    monitor_points_ = recorder.monitor_points();
    end_stages();
    recorder.finish(data_.analysis == input::AnalysisKind::run);
    if (data_.analysis == input::AnalysisKind::run) add_runout();
  }

  void warn_about(const input::Stage& stage, const StageReport& report, bool last) {
    if (stage.until == input::Until::rest && report.end != StageEnd::rest) {
      warnings_.push_back(
          fmt::format("stage '{}' was not at rest after {:g} s: its unbalanced force is {:.2g} of gravity", stage.name,
                      stage.duration, report.force_ratio));
    } else if (stage.until == input::Until::time && report.force_ratio > restless_force_ratio &&
               (!last || data_.analysis == input::AnalysisKind::strength_reduction)) {
      warnings_.push_back(fmt::format(
          "stage '{}' ended with an unbalanced force of {:.2g} of gravity; what follows starts from a moving slope",
          stage.name, report.force_ratio));
    }
  }

  void add_trial_timing(const mpm::Timing& timing) {
    const std::lock_guard lock(adding_);
    trial_timing_ += timing;
  }

  /// Seconds of all threads by part, for people.
  json list_parts(double cpu) const {
    json parts = json::array();
    const auto add = [&](const char* name, const char* title, double seconds) {
      if (seconds > 0) parts.push_back({{"name", name}, {"title", title}, {"seconds", seconds}});
    };
    mpm::Timing steps = body_.timing;
    steps += trial_timing_;
    add("preparation", "mesh and material points", preparation_);
    add("solve_momentum", "momentum balance at the nodes", steps.solve_momentum);
    add("remap_momentum", "remapping of the momentum", steps.remap_momentum);
    add("smooth_strain", "smoothing of the strain", steps.smooth_strain);
    add("advance_points", "material points: motion, strain, stress", steps.advance_points);
    add("smooth_return", "smoothing of the stress return", steps.smooth_return);
    add("relocate", "points that changed their element", steps.relocate);
    double known = 0;
    for (const json& part : parts) known += part.at("seconds").get<double>();
    add("other", "loads, time step, rest, meshes of trials, output", cpu - known);
    return parts;
  }

  /// Stage reports outlive an interruption beside the checkpoint.
  fs::path stage_file() const { return options_.folder / "stages.json"; }
  void save_stage_reports() const {
    write_atomically(stage_file(), json{{"stages", stages_}, {"warnings", warnings_}}.dump(2) + "\n");
  }
  void load_stage_reports(int count) {
    std::ifstream file(stage_file());
    if (!file) return;
    const json kept = json::parse(file);
    stages_ = kept.at("stages");
    warnings_ = kept.at("warnings").get<std::vector<std::string>>();
    while (static_cast<int>(stages_.size()) > count) stages_.erase(stages_.size() - 1);
  }

  void add_runout() {
    const Runout runout = find_runout(body_, initial_, find_onset_threshold(data_.output, slope_height_));
    summary_["runout"] = to_json(runout);
    if (const auto time = find_failure_time(options_.folder / "history.csv",
                                            data_.strength_reduction.curve.displacement_ratio * slope_height_))
      summary_["failure_time"] = *time;
    write_profiles(options_.folder / "profile.csv", initial_, find_profile(body_, profile_bin_));
  }

  void finish_summary(std::chrono::steady_clock::time_point start, double cpu_start) {
    if (!body_.lost.empty()) {
      double mass = 0;
      for (const auto& l : body_.lost) mass += l.mass;
      warnings_.push_back(fmt::format(
          "{} points with {:.1f} kg left the grid (the first at t = {:.4g} s); enlarge the box if they matter",
          body_.lost.size(), mass, body_.lost.front().time));
    }
    summary_["stages"] = stages_;
    try {
      describe_output(summary_, data_, options_.folder);
    } catch (const Error& error) {
      warnings_.push_back(error.what());  // a table that cannot be made must not cost the summary
    }
    summary_["warnings"] = warnings_;
    const double cpu = process_seconds() - cpu_start;
    summary_["timing"] = {{"wall", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
                          {"cpu", cpu},
                          {"stage_steps", describe_timing(body_.timing)},
                          {"parts", list_parts(cpu)}};
    if (options_.end) options_.end(summary_);
    summary_["results"] = list_results(data_, summary_);
    summary_["comparisons"] = compare_results(data_, summary_);
    write_atomically(options_.folder / "summary.json", summary_.dump(2) + "\n");
    if (summary_["status"] == "finished") fs::remove(stage_file());
  }

  const input::LoadedCase& loaded_;
  const input::Case& data_;
  const RunOptions& options_;
  std::string hash_, checkpoint_hash_;    ///< of the input; together with the state that it starts from
  json mesh_input_ = loaded_.echo.get();  ///< echo of the case that the mesh was made for
  mpm::Work work_before_;
  mpm::Body<D> body_;
  double slope_height_ = 0, profile_bin_ = 0, preparation_ = 0, initial_water_ = 0;
  mpm::Timing trial_timing_;
  std::mutex adding_;
  Profile initial_;
  std::vector<int> monitor_points_;
  json summary_, stages_ = json::array();
  std::vector<std::string> warnings_;
};

}  // namespace

std::string hash_input(json echo) {
  for (const char* block : {"output", "project", "compare"}) echo.erase(block);
  const std::function<void(json&)> strip = [&](json& node) {
    if (node.is_object()) node.erase("courant");
    if (node.is_structured()) std::for_each(node.begin(), node.end(), strip);
  };
  strip(echo);
  return hash_text(echo.dump());
}

json run_points(const input::LoadedCase& loaded, const RunOptions& options) {
  const std::string hash = hash_input(loaded.echo.get());
  check_folder(loaded.data.initial, options);
  if (auto finished = load_finished(options, hash)) {
    renew_finished(*finished, loaded.data, options.folder);
    return *finished;
  }
  if (loaded.data.mesh.dimension == 2) return CaseRun<2>(loaded, options, hash).run();
  return CaseRun<3>(loaded, options, hash).run();
}

}  // namespace talus::run
