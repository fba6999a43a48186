// SPDX-License-Identifier: MIT
#pragma once
// The stages of a case by MPM, one after the other, with their records, reports and warnings.

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/point_preparation.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/mpm/stage/helpers.hpp"

namespace talus::run {

template <int D>
class PointStages {
 public:
  /// `points`: prepared; its body advances, and it receives the warnings. `helpers`: the other ranks if only this one
  /// has the body, else null. All arguments must outlive this object.
  PointStages(const input::Case& data, const RunOptions& options, PreparedPoints<D>& points, Helpers<D>* helpers)
      : data_(data), options_(options), points_(points), helpers_(helpers) {}

  /// Runs the stages, or those after the checkpoint. Throws Error (unstable, interrupted, cannot_write).
  void run();
  /// The stages that ended.
  const std::vector<results::Stage>& list() const { return stages_; }
  /// Points nearest to the monitors.
  const std::vector<int>& monitor_points() const { return monitor_points_; }
  /// Removes the file that only a resumed run needs.
  void forget() const;

 private:
  RecorderSettings make_settings() const;
  void run_one(int number, StageState& state, Recorder<D>& recorder);
  results::Stage make_report(const StagePlan<D>& plan, const StageState& state, results::StageEnd end) const;
  void warn_before(const StagePlan<D>& plan);
  void warn_after(const input::Stage& stage, const results::Stage& report, bool is_last);
  std::filesystem::path file() const { return options_.folder / "stages.json"; }
  void load(int count);

  const input::Case& data_;
  const RunOptions& options_;
  PreparedPoints<D>& points_;
  Helpers<D>* helpers_;
  std::vector<results::Stage> stages_;
  std::vector<int> monitor_points_;
};

}  // namespace talus::run
