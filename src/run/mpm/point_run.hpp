// SPDX-License-Identifier: MIT
#pragma once
// MPM on a case: mesh, initial state, stages, and strength reduction or runout.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/ranks.hpp"
#include "input/read.hpp"
#include "mpm/solver/step.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/stage/helpers.hpp"
#include "run/mpm/start/end_state.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

/// Evaluates onset of movement and sections from the histories and frames of a run. They can be evaluated again, with
/// other settings, after the run has finished.
void read_output(results::RunResult& run, const input::Case& data, const std::filesystem::path& folder);

/// CPU time of all threads of this process [s].
double find_process_seconds();

template <int D>
class PointRun {
 public:
  /// `data` is the case itself or its design values. `loaded`, `data` and `options` must outlive the run.
  PointRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options, std::string input_hash);

  /// Prepares mesh, points and their initial state, and describes them in `run`. Throws InputError if names do not fit
  /// the mesh, and what meshing and preparation throw; writes nothing.
  void prepare(results::RunResult& run);
  /// Writes the files that precede the first step.
  void open();
  /// Runs the stages, then the strength reduction or the runout. Throws Error (unstable, interrupted, cannot_write);
  /// results obtained before the failure are in `run`.
  void calculate(results::RunResult& run);
  /// Completes `run` with stages, warnings and the results that are read from files, however the run ended.
  void finish(results::RunResult& run);
  /// Seconds by part; `cpu` is the CPU time of the whole process.
  std::vector<results::TimedPart> list_parts(double cpu) const;
  results::StepSeconds get_stage_seconds() const;
  /// Water fields of the initial state; nullptr if there are none.
  const results::WaterFields* water_fields() const { return water_.fields ? &*water_.fields : nullptr; }
  /// Removes the files that only a resumed run needs.
  void forget();
  /// Returns true on a rank without results of its own, which takes part in the stages of calculate() on rank 0.
  static bool helps(const input::Case& data) { return shares_stages(data) && get_ranks().rank() > 0; }

 private:
  /// Returns true if there are several ranks and only rank 0 has the body. In a strength reduction the trials start
  /// from the body on every rank.
  static bool shares_stages(const input::Case& data) {
    return get_ranks().size() > 1 && input::uses(data, Method::mpm) && data.analysis == input::AnalysisKind::run;
  }
  void prepare_body(results::RunResult& run);
  void open_origin();
  void write_origin(const EndState& origin, results::RunResult& run);
  void check_names(const mesh::Mesh<D>& mesh) const;
  void run_stages(results::RunResult& run);
  void warn_about(const input::Stage& stage, const results::Stage& report, bool last);
  void end_stages(results::RunResult& run);
  void add_runout(results::RunResult& run);
  std::filesystem::path stage_file() const { return options_.folder / "stages.json"; }
  void save_stages() const;
  void load_stages(int count);

  const input::LoadedCase& loaded_;
  const input::Case& data_;
  const RunOptions& options_;
  std::string hash_, checkpoint_hash_;  ///< of the input; of the input and the state that the run starts from
  JsonTree mesh_input_;                 ///< echo of the case for which the mesh was generated
  std::unique_ptr<EndState> origin_;
  std::unique_ptr<output::ArchiveReader> checkpoint_;
  mpm::Work work_before_;
  mpm::Body<D> body_;
  std::optional<site::SeasonRecord> season_;
  site::WaterResult water_;
  double slope_height_ = 0, profile_bin_ = 0, preparation_ = 0, initial_water_ = 0;
  mpm::Timing trial_timing_;
  std::mutex adding_;
  RunoutStart runout_start_;
  std::vector<int> monitor_points_;
  std::vector<results::Stage> stages_;
  std::vector<std::string> warnings_;
  Helpers<D> helpers_;
};

}  // namespace talus::run
