// SPDX-License-Identifier: MIT
#pragma once
// What is kept while a stage or a trial runs: frames, histories, checkpoints, and the line of progress.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/progress.hpp"
#include "output/files/archive.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "run/mpm/record/frame.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/record/water_record.hpp"
#include "run/mpm/stage.hpp"

namespace talus::run {

struct RecorderSettings {
  std::filesystem::path folder;
  std::string checkpoint_name = "checkpoint.h5";
  std::string input_hash;  ///< of the case; a checkpoint of another one is refused
  const input::Case* data = nullptr;
  bool keeps_history = true;
  bool keeps_frames = true;
  double frame_interval = 0;  ///< [s]; 0: only at the end
  Progress* progress = nullptr;
  std::string label;                ///< before the stage's name in the line of progress
  std::vector<int> monitor_points;  ///< the points that are followed; empty: those nearest to the monitors now
  const RunoutStart* runout_start = nullptr;  ///< what the columns of the front are measured from; null: without them
  mpm::Work work_before;                      ///< of the result that the case starts from; histories do not count it
};

/// One history of legs (stages, or one trial) in one folder.
template <int D>
class Recorder {
 public:
  /// A new one; what lies in the folder's files is replaced.
  static Recorder start(const RecorderSettings& settings, const mpm::Body<D>& body);
  /// Goes on from the checkpoint at `time`: rows and frames after it are dropped.
  static Recorder resume(const RecorderSettings& settings, const mpm::Body<D>& body,
                         const output::ArchiveReader& checkpoint);

  /// Hooks for run_stage of leg `index`. The plan must outlive the leg.
  StageHooks<D> begin_leg(int index, const StagePlan<D>& plan, const mpm::Body<D>& body, const StageState& state);
  /// Last row and frame of the leg, and a checkpoint that stands before leg index + 1 when `saves`.
  void end_leg(const mpm::Body<D>& body, bool saves = true);
  /// Assembles the results; removes the checkpoint when `done`.
  void finish(bool done);
  const std::vector<int>& monitor_points() const { return monitor_points_; }

 private:
  Recorder(const RecorderSettings& settings, const mpm::Body<D>& body);
  void open_histories(bool resumes);
  void write_rows(Pause<D>& now);
  void write_monitors(const mpm::Body<D>& body, const std::vector<mpm::PointView<D>>& points);
  void write_frame(const mpm::Body<D>& body);
  void write_checkpoint(const mpm::Body<D>& body, const StageState& state, int leg, const std::string& name) const;
  void on_output(Pause<D>& now, StageState& state);
  bool is_look_due() const;
  void on_look(const mpm::Body<D>& body, const StageState& state);
  GoBack<D> mark();
  void show_progress(const mpm::Body<D>& body, const StageState& state, double moved);

  RecorderSettings settings_;
  StateFields states_;
  std::optional<output::ResultsWriter> results_;
  std::optional<output::History> history_, monitors_;
  std::optional<WaterRecord<D>> water_;
  std::vector<int> monitor_points_;
  int leg_ = 0;
  const StagePlan<D>* plan_ = nullptr;
  StagePlan<D> calmed_plan_;  ///< where the leg went back to a good state: as it went on
  double next_frame_ = 0, next_row_ = 0, row_interval_ = 0, last_row_ = -1, last_frame_ = -1;
  std::chrono::steady_clock::time_point next_checkpoint_, leg_start_;
  std::int64_t leg_start_steps_ = 0;
};

/// The checkpoint in `folder`, when there is one. Throws Error (wrong_input) when it belongs to another case.
std::unique_ptr<output::ArchiveReader> open_checkpoint(const std::filesystem::path& path,
                                                       const std::string& input_hash);

/// Number of the leg that a checkpoint stands in.
int get_leg(const output::ArchiveReader& checkpoint);

}  // namespace talus::run
