// SPDX-License-Identifier: MIT
#pragma once
// Variants of a case, each in a folder of its own, in parallel on the threads: the implementation of `talus study`.

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
  std::filesystem::path folder;  ///< folder of the tables, the plot, and a folder for each variant
  int threads = 1;               ///< variants in parallel; each uses one thread
  bool resume = false;           ///< keep finished variants, resume interrupted ones
  bool overwrite = false;        ///< replace existing results
  Progress* progress = nullptr;
};

/// Outcome of a variant.
struct StudyRow {
  results::StudyVariant summary;
  ExitCode code = ExitCode::success;
  bool kept = false;                         ///< finished in an earlier call and not repeated
  std::optional<results::RunResult> result;  ///< of the run, as far as it proceeded
};

/// Throws Error (folder_exists) if the folder of the study is a file, holds something that is neither to be replaced
/// nor resumed, or must not be replaced (run::check_replaced); `ways` lists the alternatives for the message.
void check_folder(const input::LoadedCase& base, const StudyPlan& plan, const StudyOptions& options,
                  const std::string& ways);

/// Starts or continues the list of the files of a study in its folder, which the caller has locked. With --overwrite
/// the files of the previous study, its variants and jobs are removed.
std::unique_ptr<FileList> open_folder(const StudyPlan& plan, const StudyOptions& options);

/// Reads the results in the folder of a variant; nullopt if a file is damaged.
std::optional<results::RunResult> load_variant(const std::filesystem::path& folder);

/// Sets the status of a finished variant to failed if files of its run are missing or have changed since.
void check_row(const std::filesystem::path& folder, StudyRow& row);

/// Throws Error (wrong_input) if a variant that would be kept is of another input.
void check_variants(const StudyPlan& plan, const StudyOptions& options);

/// Returns the row of a variant before its run.
StudyRow begin_row(const Variant& variant);
/// Returns the row of a variant of which an earlier call may have finished the run: it is kept, or failed if files are
/// missing.
StudyRow load_row(const Variant& variant, const StudyOptions& options);

struct RowRun {
  int threads = 1;
  Progress* progress = nullptr;
  std::string label = {};  ///< precedes the name of a stage in the progress line
};
/// Runs a variant. A failure is part of its row.
void calculate_row(const Variant& variant, const StudyOptions& options, const RowRun& how, StudyRow& row);

/// Returns the rows of a study before it starts.
std::vector<StudyRow> begin_rows(const StudyPlan& plan);

/// Runs the variants in parallel. `renew` is called with all rows whenever a variant ends, by one thread at a time.
/// Rows are in the order of the plan.
std::vector<StudyRow> run_variants(const StudyPlan& plan, const StudyOptions& options,
                                   const std::function<void(const std::vector<StudyRow>&)>& renew);

/// Runs all variants and writes study.csv, study.json, study.md and, if there are curves, study.svg; the tables are
/// updated whenever a variant ends. A variant that fails does not stop the others: its row has the reason. Rows are in
/// the order of the plan. Throws Error (folder_exists), and Error (wrong_input) if --resume finds results of another
/// input, both before anything is written; Error (cannot_write) for the files of the study itself.
std::vector<StudyRow> run_study(const StudyPlan& plan, const StudyOptions& options);

/// Returns one error for all rows that did not finish, with the most serious code; nullopt if all did.
std::optional<Error> find_failure(const std::vector<StudyRow>& rows);

// A study of any mode: its forecast, and the common entry of `talus study` and Python's talus.study.

struct StudyOutcome {
  std::string tables;            ///< study.md
  std::optional<Error> failure;  ///< of variants or samples that did not finish
};

/// Runs the variants or the samples of the case, which was read with `overrides`. Throws what run_study() and
/// run_sampling() throw.
StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options);

/// Returns "a study varies 3 keys: 24 runs, about 10 minutes"; empty if the case has no study. The time is that of
/// consecutive runs. Throws InputError with the faults of the variants.
std::string forecast_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
