// SPDX-License-Identifier: MIT
#pragma once
// Material points on a case: from the mesh through stages and trials to how far the soil ran.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/ranks.hpp"
#include "ground/seepage_results.hpp"
#include "input/read.hpp"
#include "mpm/step/step.hpp"
#include "results/run.hpp"
#include "run/mpm/ranks_stage.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// Onset of movement and sections, from the histories and frames that a run has written. A finished run may ask for
/// others than it did when it was calculated.
void read_output(results::RunResult& run, const input::Case& data, const std::filesystem::path& folder);

/// The seconds of all threads that this process has used.
double find_process_seconds();

template <int D>
class PointRun {
 public:
  /// `data`: what is calculated, the case itself or its design values. All three must outlive the run.
  PointRun(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options, std::string input_hash);

  /// Mesh, points and their state at the start, into `run`. Throws InputError when names do not fit the mesh, and what
  /// meshing and preparing throw; nothing is written.
  void prepare(results::RunResult& run);
  /// What the folder gets before the first step.
  void open();
  /// Stages, and the strength reduction or the runout. Throws Error (unstable, interrupted, cannot_write); what was
  /// found before stands in `run`.
  void calculate(results::RunResult& run);
  /// Stages, warnings and the results from the files, of a run that ended in any way.
  void finish(results::RunResult& run);
  /// Seconds by part; `cpu`: of the whole process.
  std::vector<results::TimedPart> list_parts(double cpu) const;
  results::StepSeconds get_stage_seconds() const;
  /// Fields of the water that the points begin with; nullptr where there are none.
  const results::WaterFields* water_fields() const { return water_.fields ? &*water_.fields : nullptr; }
  /// What outlives an interruption only.
  void forget();
  /// Whether this is a rank without results of its own: it helps rank 0 with the stages of calculate().
  static bool helps(const input::Case& data) { return shares_stages(data) && get_ranks().rank() > 0; }

 private:
  /// Whether there are several ranks, of which rank 0 alone has the body. Trials of a reduction begin with the body on
  /// every rank.
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
  std::string hash_, checkpoint_hash_;  ///< of the input; together with the state that it starts from
  JsonTree mesh_input_;                 ///< echo of the case that the mesh was made for
  std::unique_ptr<EndState> origin_;
  std::unique_ptr<output::ArchiveReader> checkpoint_;
  mpm::Work work_before_;
  mpm::Body<D> body_;
  std::optional<ground::SeasonRecord> season_;
  ground::WaterResult water_;
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
