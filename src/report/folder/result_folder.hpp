// SPDX-License-Identifier: MIT
#pragma once
// A folder of results as it is read for a report: a run that has finished or was interrupted or killed, a study, or
// element tests.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "input/case/case.hpp"
#include "output/files/frames_reader.hpp"
#include "results/laboratory.hpp"
#include "results/present.hpp"
#include "results/run.hpp"
#include "results/study.hpp"

namespace talus::report {

/// Opens the frames of `folder`; returns nullptr if there are none. Throws Error (wrong_input) if a file is damaged.
std::shared_ptr<const output::ResultsReader> open_frames(const std::filesystem::path& folder);

/// A trial of the displacement curve, such as folder/trials/srf_1.4500.
struct TrialFolder {
  std::filesystem::path path;
  double factor = 0;
  std::optional<results::Trial> result;  ///< trial.json; nullopt while the trial has not finished
  bool runs_out = false;                 ///< the trial is continued until rest
};

struct ResultFolder {
  std::filesystem::path path;
  results::RunResult run;  ///< from summary.json; without one, from the other files of the run
  std::optional<results::PresentReduction> reduction;   ///< in progress
  input::Case data;                                     ///< case of `run`
  std::vector<TrialFolder> trials;                      ///< in order of the factor
  std::shared_ptr<const output::ResultsReader> frames;  ///< of the stages; nullptr if there are none
  std::optional<results::StudyResult> study_result;     ///< study.json
  std::optional<results::PointTests> tests;             ///< point/point.json
  std::optional<results::Calibration> calibration;      ///< calibration/calibration.json
  bool has_tests_alone = false;                         ///< the folder contains neither a run nor a study

  bool is_study() const { return study_result.has_value(); }
};

/// Returns 2 or 3.
std::size_t get_dimension(const results::RunResult& run);

/// Reads the run in `path` from summary.json only; returns nullopt if there is none. Throws Error (wrong_input) if the
/// file is damaged.
std::optional<ResultFolder> open_run(const std::filesystem::path& path);

/// Throws Error (wrong_input) if `path` is not a results folder.
ResultFolder open_folder(const std::filesystem::path& path);

}  // namespace talus::report
