// SPDX-License-Identifier: MIT
#include "run/run_case.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/user_file.hpp"
#include "input/echo.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "results/present.hpp"
#include "run/bounds/referee.hpp"
#include "run/case_results.hpp"
#include "run/common/head.hpp"
#include "run/common/method_run.hpp"
#include "run/forecast/forecast.hpp"
#include "run/mpm/coarser_mesh.hpp"
#include "run/mpm/stage/stepper.hpp"

namespace talus::run {
namespace {

results::Status find_status(ExitCode code) {
  if (code == ExitCode::interrupted) return results::Status::interrupted;
  return code == ExitCode::unstable ? results::Status::unstable : results::Status::failed;
}

/// The run of one case in D dimensions: the sequence of its methods.
template <int D>
class CaseRun {
 public:
  /// `options` are those of the context.
  CaseRun(const CaseContext& context, RunOptions& options, FolderLock& lock) : context_(context), lock_(lock) {
    if (options.keeps_present) options.store_present = [this] { clock_.update([this] { keep_present(); }); };
  }

  results::RunResult run() {
    prepare_methods(context_, methods_, run_);
    if (PointRun<D>::helps(data_)) {
      calculate();
      return std::move(run_);
    }
    try {
      calculate();
      run_.status = results::Status::finished;
    } catch (...) {
      clear_progress();
      if (!files_) throw;
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
    clear_progress();
    finish();
    return std::move(run_);
  }

 private:
  void calculate() {
    if (methods_.slices && !methods_.points)
      calculate_slices();  // LEM alone may find no surface, and then nothing is written
    open();
    if (methods_.slices) {
      if (methods_.points) calculate_slices();
      methods_.slices->keep();
    }
    keep_present();
    if (methods_.construction) methods_.construction->calculate(), keep_present();
    if (methods_.timeline)
      methods_.timeline->calculate(methods_.slices->prepared(), methods_.slices->result()), keep_present();
    if (methods_.timeline && methods_.elements) reduce_in_time();
    if (is_released(data_)) releases_.prepare(run_);
    if (methods_.elements) methods_.elements->calculate(), keep_present();
    if (methods_.bounds) methods_.bounds->calculate(find_start()), keep_present();
    if (methods_.seepage) methods_.seepage->calculate(), keep_present();
    if (methods_.points) {
      methods_.points->calculate(run_);
      has_points_ = true;
      if (auto why = compare_with_coarser_mesh<D>(context_.loaded, *methods_.point_case, context_.options,
                                                  context_.hash, run_))
        methods_.point_notes.push_back(std::move(*why));
    }
    releases_.run_beside();
  }

  /// Runs the search, and the referee on its result.
  void calculate_slices() {
    methods_.slices->calculate();
    if (methods_.slices->needs_referee())
      methods_.slices->take_referee(search_referee_interval(data_, find_start(), context_.options));
    clear_progress();
  }

  /// Runs FEM at times of the timeline, each in a folder of its own.
  void reduce_in_time() {
    for (ReductionCase& reduction : methods_.timeline->list_reductions()) {
      const RunOptions options =
          context_.options.make_nested(join_name(context_.options.folder, reduction.summary.folder));
      make_folder(options.folder);
      results::RunResult found;
      ElementRun<D> elements(reduction.data, false, options,
                             hash_text(fmt::format("{}{:a}", context_.hash, reduction.summary.time)));
      elements.prepare();
      elements.calculate();
      elements.write_result(found);
      if (found.elements) {
        reduction.summary.error = found.elements->error;
        reduction.summary.runs = std::move(found.elements->runs);
      }
      methods_.timeline->add_reduction(std::move(reduction.summary));
    }
  }

  /// Returns a factor from which limit analysis starts; the bounds do not depend on it.
  std::optional<double> find_start() const {
    const auto governing = methods_.slices ? results::find_governing_surface(methods_.slices->result(), nullptr)
                                           : std::optional<results::GoverningSurface>();
    return governing ? governing->found->surface.factor : std::nullopt;
  }

  /// Opens the folder before the first result.
  void open() {
    const input::LoadedCase& loaded = context_.loaded;
    const RunOptions& options = context_.options;
    lock_.take();
    check_folder(loaded, options);  // another run may have ended there since the first check
    if (options.overwrite)
      replace_folder(
          options.folder, [&](const auto& file) { return is_of_run(loaded.data, file); }, options.progress);
    files_.emplace(options.folder);
    remove_present(options);
    if (options.keeps_present) make_folder(options.folder / results::present_folder);
    if (methods_.points) methods_.points->open();
  }

  /// Stores what the methods have found so far.
  void keep_present() {
    if (context_.options.keeps_present) write_present_results(context_, methods_, run_);
  }

  void finish() { write_case_results(context_, methods_, releases_, start_, has_points_, run_); }

  void clear_progress() {
    if (context_.options.progress) context_.options.progress->clear();
  }

  const CaseContext& context_;
  const input::Case& data_ = context_.design.data;
  const RunStart start_;
  FolderLock& lock_;
  std::optional<FileList> files_;  ///< from the first file on
  CaseMethods<D> methods_;
  Releases<D> releases_{context_, methods_};
  bool has_points_ = false;  ///< MPM of the run itself was completed
  results::RunResult run_;
  PresentClock clock_;
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

results::RunResult run_case(const input::LoadedCase& loaded, const RunOptions& options) {
  const std::string hash = input::hash_input(loaded.echo, loaded.data);
  site::DesignValues design = site::apply_partial_factors(loaded.data);
  refuse_above_memory(loaded);
  const ChosenDevice device(design.data, options);
  check_folder(loaded, options);
  FolderLock lock(options.folder);
  lock.take_existing();
  if (options.resume && has_list(options.folder)) check_kept(options.folder);
  if (auto finished = load_finished(options, hash)) return renew(std::move(*finished), loaded.data, options);
  RunOptions own = options;
  const CaseContext context{loaded, std::move(design), own, hash};
  return loaded.data.mesh.dimension == 2 ? CaseRun<2>(context, own, lock).run() : CaseRun<3>(context, own, lock).run();
}

}  // namespace talus::run
