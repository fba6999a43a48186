// SPDX-License-Identifier: MIT
#pragma once
// Output during a stage or a trial: frames, histories, checkpoints, and the progress line.

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
#include "run/mpm/stage/stage.hpp"

namespace talus::run {

struct RecorderSettings {
  std::filesystem::path folder;
  std::string checkpoint_name = "checkpoint.h5";
  std::string input_hash;  ///< of the case; a checkpoint of another case is refused
  const input::Case* data = nullptr;
  bool keeps_history = true;
  bool keeps_frames = true;
  double frame_interval = 0;  ///< [s]; 0: only at the end
  Progress* progress = nullptr;
  std::string label;                          ///< precedes the name of the stage in the progress line
  std::vector<int> monitor_points;            ///< monitored points; empty: those nearest to the monitors at the start
  const RunoutStart* runout_start = nullptr;  ///< reference of the front columns; null: no such columns
  mpm::Work work_before;                      ///< work of the result that the case starts from; subtracted in histories
};

/// Recording of consecutive legs (the stages, or one trial) in one folder.
template <int D>
class Recorder {
 public:
  /// Starts a new recording; replaces existing files of the folder.
  static Recorder start(const RecorderSettings& settings, const mpm::Body<D>& body);
  /// Resumes from `checkpoint`: rows and frames after its time are dropped.
  static Recorder resume(const RecorderSettings& settings, const mpm::Body<D>& body,
                         const output::ArchiveReader& checkpoint);

  /// Returns the hooks for run_stage of leg `index`. The plan must outlive the leg.
  StageHooks<D> begin_leg(int index, const StagePlan<D>& plan, const mpm::Body<D>& body, const StageState& state);
  /// Writes the last row and frame of the leg and, when `saves`, a checkpoint at the start of leg index + 1.
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
  StagePlan<D> calmed_plan_;  ///< the changed plan after a retry with a smaller step
  double next_frame_ = 0, next_row_ = 0, row_interval_ = 0, last_row_ = -1, last_frame_ = -1;
  std::chrono::steady_clock::time_point next_checkpoint_, leg_start_;
  std::int64_t leg_start_steps_ = 0;
};

/// The recording of legs that start anew or resume.
template <int D>
struct RecordedRun {
  Recorder<D> recorder;
  StageState state;  ///< of the first leg
  int first = 0;     ///< leg that comes next
};

/// Starts a recording with `body`. With a checkpoint (null: none) it resumes there, and `body` takes its state.
template <int D>
RecordedRun<D> begin_recording(const RecorderSettings& settings, mpm::Body<D>& body,
                               const output::ArchiveReader* checkpoint);

}  // namespace talus::run
