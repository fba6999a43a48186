// SPDX-License-Identifier: MIT
#pragma once
// Many variants of a case, each in a folder of its own, side by side on the threads: the work behind `talus study`.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/progress.hpp"
#include "results/run.hpp"
#include "results/study.hpp"
#include "study/study_plan.hpp"

namespace talus::study {

struct StudyOptions {
  std::filesystem::path folder;  ///< gets the tables, the plot, and a folder for each variant
  int threads = 1;               ///< variants side by side; each uses one thread
  bool resume = false;           ///< finished variants are kept, interrupted ones go on
  bool overwrite = false;        ///< replace results that are there
  Progress* progress = nullptr;
};

/// How a variant went.
struct StudyRow {
  results::StudyVariant summary;
  ExitCode code = ExitCode::success;
  bool kept = false;                         ///< finished in an earlier call and not run again
  std::optional<results::RunResult> result;  ///< the run's, as far as it came
};

/// Throws Error (folder_exists) when the study's folder is a file, or holds something that is neither to be replaced
/// nor to go on, or must not be replaced (run::check_replaced); `ways` says what else can be done.
void check_folder(const input::LoadedCase& base, const StudyPlan& plan, const StudyOptions& options,
                  const std::string& ways);

/// Begins the list of the files of a study in its folder, which is held by the caller, or continues it. With
/// --overwrite those of the study before, its variants and jobs go.
std::unique_ptr<FileList> open_folder(const StudyPlan& plan, const StudyOptions& options);

/// The results in the folder of a variant; nothing where a file is damaged.
std::optional<results::RunResult> load_variant(const std::filesystem::path& folder);

/// The status of a variant that has finished: failed where files of its run are missing or have changed since.
void check_row(const std::filesystem::path& folder, StudyRow& row);

/// Throws Error (wrong_input) when a variant that is to be kept is of another input.
void check_variants(const StudyPlan& plan, const StudyOptions& options);

/// The rows of a study before it begins.
std::vector<StudyRow> begin_rows(const StudyPlan& plan);

/// Calculates the variants side by side. `renew` is told all rows whenever a variant has ended, from one thread at a
/// time. Rows are in the order of the plan.
std::vector<StudyRow> run_variants(const StudyPlan& plan, const StudyOptions& options,
                                   const std::function<void(const std::vector<StudyRow>&)>& renew);

/// Runs all variants and writes study.csv, study.json, study.md and, where there are curves, study.svg; the tables are
/// renewed whenever a variant ends. A variant that fails does not stop the others: its row says why. Rows are in the
/// order of the plan. Throws Error (folder_exists), Error (wrong_input) when --resume meets results of another input,
/// both before anything is written; Error (cannot_write) for the study's own files.
std::vector<StudyRow> run_study(const StudyPlan& plan, const StudyOptions& options);

/// One error for all rows that did not finish, with the most serious code; nothing when all did.
std::optional<Error> find_failure(const std::vector<StudyRow>& rows);

// A study whatever its mode: its forecast, and the one entry behind `talus study` and Python's talus.study.

struct StudyOutcome {
  std::string tables;            ///< study.md
  std::optional<Error> failure;  ///< of variants or samples that did not finish
};

/// Calculates the variants or the samples of the case, which was read with `overrides`. Errors as run_study() and
/// run_sampling().
StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options);

/// "a study varies 3 keys: 24 runs, about 10 minutes"; empty where the case has no study. The time is that of runs one
/// after another. Throws InputError with the faults of the variants.
std::string forecast_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
