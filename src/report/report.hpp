// SPDX-License-Identifier: MIT
#pragma once
// The report of a results folder: one HTML file that needs nothing else (docs/manual/report.md).

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "output/files/frames_reader.hpp"
#include "report/pack/pack.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "results/study.hpp"

namespace talus::report {

// What a results folder holds: of a finished run, of one that was interrupted or killed, of a study, or
// of element tests.

/// The frames of `folder`; nullptr when it has none. Throws Error (wrong_input) when a file is damaged.
std::shared_ptr<const output::ResultsReader> open_frames(const std::filesystem::path& folder);

/// A trial of the displacement curve: folder/trials/srf_1.4500.
struct TrialFolder {
  std::filesystem::path path;
  double factor = 0;
  std::optional<results::Trial> result;  ///< trial.json; nothing while the trial is not finished
  bool runs_out = false;                 ///< goes on after the trial until rest
};

struct ResultFolder {
  std::filesystem::path path;
  results::RunResult run;           ///< summary.json; of a run that did not write it, from its other files
  input::Case data;                 ///< the case of `run`
  std::vector<TrialFolder> trials;  ///< by factor
  std::shared_ptr<const output::ResultsReader> frames;  ///< of the stages; nullptr when there are none
  std::optional<results::StudyResult> study_result;     ///< study.json
  std::optional<results::PointTests> tests;             ///< point/point.json
  bool has_tests_alone = false;                         ///< neither a run nor a study

  bool is_study() const { return study_result.has_value(); }
};

/// 2 or 3.
std::size_t get_dimension(const results::RunResult& run);

/// The run in `path` from summary.json alone; nothing when there is none. Throws Error (wrong_input).
std::optional<ResultFolder> open_run(const std::filesystem::path& path);

/// Throws Error (wrong_input) with one sentence when `path` is no folder of results.
ResultFolder open_folder(const std::filesystem::path& path);

/// The document of web/src/contract/ and the arrays beside it.
struct Content {
  JsonTree document;
  std::vector<PackedText> arrays;
};

/// Collects what `folder` holds: of a run, finished or not, or of a study. Throws Error (wrong_input) with one sentence
/// when it holds no results or one of its files is damaged.
Content collect_report(const std::filesystem::path& folder);

/// Writes `folder`/report.html, whole or not at all, and returns its path. Throws as collect_report, and Error
/// (cannot_write).
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace talus::report
