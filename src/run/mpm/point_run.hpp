// SPDX-License-Identifier: MIT
#pragma once
// MPM on a case: mesh, initial state, stages, and strength reduction or runout.

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "base/ranks.hpp"
#include "input/read.hpp"
#include "results/run.hpp"
#include "run/mpm/point_preparation.hpp"
#include "run/mpm/point_stages.hpp"

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
  const results::WaterFields* water_fields() const { return points_.water.fields ? &*points_.water.fields : nullptr; }
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
  void run_stages(results::RunResult& run);

  const input::LoadedCase& loaded_;
  const input::Case& data_;
  const RunOptions& options_;
  const std::string hash_;  ///< of the input
  PreparedPoints<D> points_;
  Helpers<D> helpers_;
  PointStages<D> stages_;
  mpm::Timing trial_timing_;
  std::mutex adding_;
};

/// Makes the case of an MPM run beside that of the case; its results so far are those of the argument.
using MakePointCase = std::function<const input::Case&(results::RunResult&)>;

/// Runs MPM on another form of the case, in the folder of the options within that of the run, unless it is finished
/// there and --resume keeps it. `complete` adds results before they are written. All ranks call it together; the others
/// than rank 0 may return an empty result. Throws what PointRun throws.
template <int D>
results::RunResult run_points_beside(const input::LoadedCase& loaded, const RunOptions& options,
                                     const std::string& input_hash, const MakePointCase& make_case,
                                     const std::function<void(results::RunResult&)>& complete);

}  // namespace talus::run
