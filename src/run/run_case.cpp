// SPDX-License-Identifier: MIT
#include "run/run_case.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/user_file.hpp"
#include "input/echo.hpp"
#include "mesh/generate.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "results/named.hpp"
#include "run/bounds/bounds_run.hpp"
#include "run/bounds/referee.hpp"
#include "run/compare/compare.hpp"
#include "run/compare/reading.hpp"
#include "run/fem/element_run.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/fem/start_stress.hpp"
#include "run/forecast/forecast.hpp"
#include "run/head.hpp"
#include "run/lem/run_lem.hpp"
#include "run/lem/slice_run.hpp"
#include "run/mpm/coarser_mesh.hpp"
#include "run/mpm/point_run.hpp"
#include "run/mpm/stepper.hpp"
#include "run/run_folder.hpp"
#include "run/timeline/timeline_run.hpp"
#include "site/design_values.hpp"
#include "site/ground_line.hpp"
#include "site/initial_water.hpp"

namespace talus::run {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* summary_file = "summary.json";

/// Returns true if MPM needs FEM, for its initial stress or its time of release.
bool asks_for_elements(const input::Case& data) {
  if (!input::uses(data, Method::mpm)) return false;
  return data.initial.stress == input::InitialStress::elements ||
         (data.timeline && data.timeline->release &&
          data.timeline->release->criterion == input::ReleaseCriterion::equilibrium);
}

/// Returns warnings of faults of ground and water that affect every method.
std::vector<std::string> list_ground_warnings(const input::Case& data) {
  std::vector<std::string> sentences = site::find_odd_water(data);
  for (const site::SteepFace& face : site::find_steep_faces(data))
    sentences.push_back(site::describe(face, data.units().length));
  if (std::string quake = site::describe_factored_quake(data); !quake.empty()) sentences.push_back(std::move(quake));
  return sentences;
}

/// One case in D dimensions.
template <int D>
class CaseRun {
 public:
  CaseRun(const input::LoadedCase& loaded, site::DesignValues design, const RunOptions& options, std::string hash,
          FolderLock& lock)
      : loaded_(loaded), design_(std::move(design)), options_(options), hash_(std::move(hash)), lock_(lock) {}

  results::RunResult run() {
    prepare();
    if (PointRun<D>::helps(design_.data)) {
      calculate();
      return std::move(run_);
    }
    try {
      calculate();
      run_.status = results::Status::finished;
    } catch (...) {
      if (options_.progress) options_.progress->clear();
      if (!is_open_) throw;
      const Failure failure = explain_failure(std::current_exception());
      run_.status = find_status(failure.code);
      run_.error = failure.sentence;
      // If the disk is full for the results, this fails too, and the first error is the one to report.
      try {
        finish();
      } catch (...) {
      }
      throw;
    }
    if (options_.progress) options_.progress->clear();
    finish();
    return std::move(run_);
  }

 private:
  static results::Status find_status(ExitCode code) {
    if (code == ExitCode::interrupted) return results::Status::interrupted;
    return code == ExitCode::unstable ? results::Status::unstable : results::Status::failed;
  }

  /// Finds all faults of the case before anything is written.
  void prepare() {
    const input::Case& data = design_.data;
    const bool alone = data.methods.size() == 1;
    const bool has_points = input::uses(data, Method::mpm), has_elements = input::uses(data, Method::fem),
               has_bounds = input::uses(data, Method::bounds);
    // Faults of FEM and limit analysis are reported before MPM, which may take hours.
    if (has_points && (has_elements || asks_for_elements(data))) check_solid(data);
    if (has_points && has_bounds) check_bounds(data);
    if (input::uses(data, Method::lem)) slices_.emplace(data, alone, options_, hash_);
    run_ = begin_result(loaded_, hash_, options_.threads);
    run_.provenance.device = describe_device();
    releases_ = has_points && data.timeline && data.timeline->release;
    if (releases_) {
      check_points(data);
    } else if (has_points) {
      point_case_ = make_point_case(data, run_, point_notes_);
      points_.emplace(loaded_, *point_case_, options_, hash_);
      points_->prepare(run_);
    } else if (data.mesh.dimension == 2 && !data.mesh.polygons.empty()) {
      run_.slope_height = site::find_slope_height(data.mesh, site::find_ground(data.mesh));
    }
    if (has_elements) elements_.emplace(data, alone, options_, hash_).prepare();
    if (has_bounds) bounds_.emplace(data, alone, options_, hash_).prepare();
    if (data.timeline) timeline_.emplace(data, options_, hash_);
  }

  /// Returns the case of MPM: with one direction of an earthquake, and with the initial stress of FEM if required.
  std::unique_ptr<const input::Case> make_point_case(const input::Case& data, results::RunResult& run,
                                                     std::vector<std::string>& notes) const {
    auto own = std::make_unique<input::Case>(data);
    if (data.earthquake.list_directions().size() > 1) notes.push_back(choose_direction(own->earthquake, data));
    if constexpr (D == 2) {
      if (data.initial.stress == input::InitialStress::elements) {
        if (options_.progress) options_.progress->show("FEM: initial stress");
        own->initial.known_stress = find_start_stress(*own, options_.threads, run.stress_start.emplace());
      }
    }
    return own;
  }

  /// MPM needs one direction of the earthquake: that in which circles have the smaller factor. Returns the sentence
  /// that states it.
  std::string choose_direction(input::Earthquake& quake, const input::Case& data) const {
    if (options_.progress) options_.progress->show("earthquake: weaker direction by circles");
    const auto weaker = find_weaker_direction(data, options_.threads);
    if (options_.progress) options_.progress->clear();
    if (!weaker)
      return "MPM takes the earthquake towards the lower end of the ground, or towards larger x where "
             "both ends are equally high: no circle shows the weaker direction. Run the other one with 'direction' "
             "under "
             "[earthquake].";
    quake.direction = *weaker;
    quake.horizontal = std::abs(quake.horizontal);
    return fmt::format(
        "MPM takes the earthquake towards {} x, where Bishop's circles have the smaller factor. Run the "
        "other one with 'direction' under [earthquake].",
        *weaker == input::EarthquakeDirection::left ? "smaller" : "larger");
  }

  /// MPM runs released later are prepared at their time; their faults are found here, at time 0.
  void check_points(const input::Case& data) const {
    RunOptions fresh = options_;
    fresh.resume = false;
    results::RunResult none;
    PointRun<D>(loaded_, data, fresh, hash_).prepare(none);
  }

  void calculate() {
    if (slices_ && !points_) calculate_slices();  // LEM alone may find no surface, and then nothing is written
    open();
    if (slices_) {
      if (points_) calculate_slices();
      slices_->keep();
    }
    if (timeline_) timeline_->calculate(slices_->prepared(), slices_->result());
    if (timeline_ && elements_) reduce_in_time();
    if (releases_) release();
    if (elements_) elements_->calculate();
    if (bounds_) bounds_->calculate(find_start());
    if (points_) {
      points_->calculate(run_);
      is_followed_ = true;
      if (auto why = compare_with_coarser_mesh<D>(loaded_, *point_case_, options_, hash_, run_))
        point_notes_.push_back(std::move(*why));
    }
    for (ReleaseCase& other : beside_) run_beside(other);
  }

  /// Runs the search, and the referee on its result.
  void calculate_slices() {
    slices_->calculate();
    if (slices_->needs_referee()) slices_->take_referee(search_referee_interval(design_.data, find_start(), options_));
    if (options_.progress) options_.progress->clear();
  }

  /// Runs FEM at times of the timeline, each in a folder of its own.
  void reduce_in_time() {
    for (ReductionCase& reduction : timeline_->list_reductions()) {
      RunOptions options = options_;
      options.folder = join_name(options.folder, reduction.summary.folder);
      make_folder(options.folder);
      results::RunResult found;
      ElementRun<D> elements(reduction.data, false, options,
                             hash_text(fmt::format("{}{:a}", hash_, reduction.summary.time)));
      elements.prepare();
      elements.calculate();
      elements.write_result(found);
      if (found.elements) {
        reduction.summary.error = found.elements->error;
        reduction.summary.runs = std::move(found.elements->runs);
      }
      timeline_->add_reduction(std::move(reduction.summary));
    }
  }

  /// Runs MPM from the time of release.
  void release() {
    beside_ = timeline_->list_releases();
    if (beside_.empty()) return;
    released_ = std::make_unique<const ReleaseCase>(std::move(beside_.front()));
    beside_.erase(beside_.begin());
    point_case_ = make_point_case(released_->data, run_, point_notes_);
    points_.emplace(loaded_, *point_case_, options_, hash_);
    points_->prepare(run_);
    points_->open();
  }

  /// Runs a release at another time, in a folder of its own.
  void run_beside(ReleaseCase& other) {
    RunOptions options = options_;
    options.folder = join_name(options.folder, other.summary.folder);
    const std::string hash = hash_text(fmt::format("{}{:a}", hash_, other.summary.time));
    const auto why = attempt(options, false, [&] {
      auto finished = load_finished(options, hash);
      if (!finished) {
        finished = begin_result(loaded_, hash, options.threads);
        make_folder(options.folder);
        std::vector<std::string> notes;
        const auto start = make_point_case(other.data, *finished, notes);
        PointRun<D> points(loaded_, *start, options, hash);
        points.prepare(*finished);
        points.open();
        points.calculate(*finished);
        if (auto coarser = compare_with_coarser_mesh<D>(loaded_, *start, options, hash, *finished))
          notes.push_back(std::move(*coarser));
        points.finish(*finished);
        finished->warnings.insert(finished->warnings.end(), notes.begin(), notes.end());
        finished->status = results::Status::finished;
        results::write_file(options.folder / summary_file, *finished);
        points.forget();
      }
      make_release_result(*finished, other.summary);
    });
    other.summary.error = why;
    results_beside_.push_back(other.summary);
  }

  static void make_release_result(const results::RunResult& run, results::Release& out) {
    if (run.stress_start) out.start_factor = run.stress_start->factor;
    if (run.stages && run.stages->size() > 1) out.rests = run.stages->front().end == results::StageEnd::rest;
    if (!run.runout) return;
    out.largest_displacement = run.runout->largest_displacement;
    out.moved_volume = run.runout->moved_volume;
    out.front_advance = run.runout->front_advance;
    out.toe_distance = run.runout->toe_distance;
    out.front_uncertainty = results::RunoutUncertainty(*run.runout).front_advance;
    out.limits = run.runout->limits;
  }

  /// Returns a factor from which limit analysis starts; the bounds do not depend on it.
  std::optional<double> find_start() const {
    const auto governing = slices_ ? results::find_governing_surface(slices_->result(), nullptr)
                                   : std::optional<results::GoverningSurface>();
    return governing ? governing->found->surface.factor : std::nullopt;
  }

  /// Opens the folder before the first result.
  void open() {
    lock_.take();
    check_folder(loaded_, options_);  // another run may have ended there since the first check
    if (options_.overwrite)
      replace_folder(
          options_.folder, [this](const auto& file) { return is_of_run(loaded_.data, file); }, options_.progress);
    files_.emplace(options_.folder);
    is_open_ = true;
    if (points_) points_->open();
  }

  void finish() {
    if (points_) points_->finish(run_);
    run_.warnings.insert(run_.warnings.end(), point_notes_.begin(), point_notes_.end());
    for (const Diagnostic& warning : loaded_.warnings) run_.warnings.push_back(warning.sentence);
    for (std::string& sentence : list_ground_warnings(design_.data)) run_.warnings.push_back(std::move(sentence));
    results::Timing& timing = run_.timing.emplace();
    timing.wall = std::chrono::duration<double>(Clock::now() - start_).count();
    if (points_) {
      timing.cpu = find_process_seconds() - cpu_start_;
      timing.stage_steps = points_->get_stage_seconds();
      timing.parts = points_->list_parts(*timing.cpu);
    }
    if (slices_) slices_->write_result(run_);
    if (elements_) elements_->write_result(run_);
    if (bounds_) bounds_->write_result(run_);
    judge_elements();
    make_timeline_result();
    if (!points_) timing.parts = list_parts();
    keep_water();
    compare();
    run_.results = list_results(loaded_.data, run_);
    run_.comparisons = compare_results(loaded_.data, run_);
    results::write_file(options_.folder / summary_file, run_);
    if (run_.status != results::Status::finished) return;
    if (points_) points_->forget();
    if (timeline_) timeline_->forget();
  }

  /// Compares FEM with ψ = φ with limit analysis, if both have the same tensile strength.
  void judge_elements() {
    const input::Case& data = design_.data;
    if (!run_.elements || !run_.bounds || !run_.bounds->is_interval() || run_.bounds->is_davis ||
        data.bounds.tension != input::BoundsTension::as_given)
      return;
    results::Referee referee;
    referee.lower = run_.bounds->lower, referee.upper = run_.bounds->upper;
    for (results::ElementRun& r : run_.elements->runs)
      if (r.flow == results::Flow::associated || !is_nonassociated(data)) r.verdict = referee.judge(r.factor);
  }

  void make_timeline_result() {
    if (!timeline_) return;
    if (released_) {
      results::Release out = released_->summary;
      make_release_result(run_, out);
      if (!is_followed_) out.error = run_.error;
      timeline_->add_release(std::move(out));
    }
    for (const results::Release& other : results_beside_) timeline_->add_release(other);
    timeline_->write_result(run_);
  }

  /// Writes water.json, the fields of the initial water of the methods, and timeline_water.json, those in time.
  void keep_water() const {
    const results::WaterFields* fields = points_ ? points_->water_fields() : nullptr;
    if (fields == nullptr && slices_) fields = slices_->water_fields();
    if (fields == nullptr && elements_) fields = elements_->water_fields();
    if (fields == nullptr && bounds_) fields = bounds_->water_fields();
    if (fields != nullptr) results::write_file(options_.folder / "water.json", *fields, -1);
    if (const results::WaterFields* in_time = timeline_ ? timeline_->water_fields() : nullptr)
      results::write_file(options_.folder / "timeline_water.json", *in_time, -1);
  }

  /// Lists the times of a run without MPM [s].
  std::vector<results::TimedPart> list_parts() const {
    std::vector<results::TimedPart> parts;
    if (run_.slices) parts.push_back({"lem", "limit equilibrium", run_.slices->seconds});
    if (run_.elements) parts.push_back({"fem", "FEM", run_.elements->seconds.value_or(0)});
    if (run_.bounds) parts.push_back({"bounds", "limit analysis", run_.bounds->seconds.value_or(0)});
    return parts;
  }

  /// MPM alone, with the values of the case, has no other method to be compared with.
  void compare() {
    if (points_ && !slices_ && !elements_ && !bounds_ && !design_.statement) return;
    run_.methods =
        compare_methods(design_.data, slices_ ? slices_->slope() : nullptr, run_, options_.folder, options_.threads);
    run_.warnings.insert(run_.warnings.begin(), run_.methods->warnings.begin(), run_.methods->warnings.end());
    run_.methods->partial_factors = design_.statement;
    if (const auto factor = results::find_main_factor(run_); factor && design_.statement)
      site::state_over_design(*run_.methods->partial_factors, design_.resistance, *factor);
  }

  const input::LoadedCase& loaded_;
  const site::DesignValues design_;
  const RunOptions& options_;
  const std::string hash_;
  const Clock::time_point start_ = Clock::now();
  const double cpu_start_ = find_process_seconds();
  FolderLock& lock_;
  std::optional<FileList> files_;  ///< from the first file on
  bool is_open_ = false;
  std::optional<SliceRun> slices_;
  std::optional<ElementRun<D>> elements_;
  std::optional<BoundsRun> bounds_;
  std::optional<TimelineRun> timeline_;
  bool releases_ = false;  ///< MPM is released from the timeline
  std::unique_ptr<const ReleaseCase> released_;
  std::vector<ReleaseCase> beside_;
  std::vector<results::Release> results_beside_;  ///< of those that ran
  bool is_followed_ = false;                      ///< MPM of the run itself was completed
  std::unique_ptr<const input::Case> point_case_;
  std::vector<std::string> point_notes_;  ///< on the earthquake direction of MPM, and on its coarser mesh
  std::optional<PointRun<D>> points_;
  results::RunResult run_;
};

/// Renews the parts of a finished run that may have changed since and do not need the run again: comparisons, results
/// from files, and the title block.
results::RunResult renew(results::RunResult run, const input::Case& data, const RunOptions& options) {
  const FileList files(options.folder);
  const nlohmann::json before = results::to_json(run);
  run.title = data.title;
  run.project = make_project(data);
  if (run.mesh) read_output(run, data, options.folder);
  run.results = list_results(data, run);
  run.comparisons = compare_results(data, run);
  if (results::to_json(run) != before) results::write_file(options.folder / summary_file, run);
  return run;
}

}  // namespace

std::vector<std::string> list_warnings(const input::LoadedCase& loaded) {
  std::vector<std::string> lines;
  for (const Diagnostic& warning : loaded.warnings) lines.push_back(input::write_warning(warning));
  if (!loaded.is_whole) return lines;
  const site::DesignValues design = site::apply_partial_factors(loaded.data);
  for (const std::string& sentence : list_ground_warnings(design.data)) lines.push_back("warning: " + sentence);
  return lines;
}

void check_ready_mesh(const input::LoadedCase& loaded) {
  constexpr std::uintmax_t most_bytes = 20'000'000;
  const mesh::Plan& plan = loaded.data.mesh;
  if (plan.file.empty() || std::filesystem::file_size(plan.file) > most_bytes) return;
  const auto check = [&](const auto& mesh) {
    std::set<std::string> sides, regions(mesh.region_names.begin(), mesh.region_names.end());
    for (const auto& [name, list] : mesh.sides) sides.insert(name);
    input::check_against_mesh(loaded, sides, regions);
  };
  if (plan.dimension == 2)
    check(mesh::generate<2>(plan));
  else
    check(mesh::generate<3>(plan));
}

void check_methods(const input::Case& data) {
  // Levels before and after a drawdown are compared in the section; its steady seepage takes seconds.
  const bool is_meshed = is_meshed_in_a_moment(data.mesh);
  const bool compares_levels = is_meshed && data.lem.drawdown && data.initial.water.season == 0;
  if (input::uses(data, Method::lem) && (compares_levels || !site::needs_seepage(data))) prepare_slope(data);
  if (input::uses(data, Method::fem) || asks_for_elements(data)) check_solid(data);
  if (!input::uses(data, Method::bounds)) return;
  check_bounds(data);
  // This makes a coarse mesh and checks its loads.
  if (is_meshed && !site::needs_seepage(data)) make_bounds_problem(data);
}

results::RunResult run_case(const input::LoadedCase& loaded, const RunOptions& options) {
  const std::string hash = input::hash_input(loaded.echo);
  site::DesignValues design = site::apply_partial_factors(loaded.data);
  refuse_above_memory(loaded);
  const ChosenDevice device(design.data, options);
  check_folder(loaded, options);
  FolderLock lock(options.folder);
  lock.take_existing();
  if (options.resume && has_list(options.folder)) check_kept(options.folder);
  if (auto finished = load_finished(options, hash)) return renew(std::move(*finished), loaded.data, options);
  if (loaded.data.mesh.dimension == 2) return CaseRun<2>(loaded, std::move(design), options, hash, lock).run();
  return CaseRun<3>(loaded, std::move(design), options, hash, lock).run();
}

}  // namespace talus::run
