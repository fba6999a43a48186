// SPDX-License-Identifier: MIT
#pragma once
// Jobs of a prepared study: each can be run separately, on any machine and repeatedly; afterwards their results are
// gathered.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "lem/surface/surface.hpp"
#include "results/study.hpp"
#include "study/study.hpp"

namespace talus::study {

// Options of the folder of a study whose jobs run anywhere: the case with its files, the list of jobs, a script for
// Slurm, and the results of the finished jobs.

struct JobOptions {
  StudyOptions study;  ///< its folder; with `resume` results of the same jobs are kept
  int jobs = 0;        ///< number of jobs; 0: from the amount of work
};

/// Plans the jobs of a study and writes them. Throws what planning throws, Error (folder_exists), and Error
/// (wrong_input) if the folder holds other jobs that would be resumed; all before anything is written.
void prepare_jobs(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                  const JobOptions& options);

/// A folder written by prepare_jobs().
class JobFolder {
 public:
  /// Throws Error (wrong_input) if the folder has no jobs, they are of another version of the program, or a file of
  /// the case has changed.
  explicit JobFolder(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  const results::StudyJobs& jobs() const { return jobs_; }
  int count() const { return static_cast<int>(jobs_.jobs.size()); }
  /// Throws Error (wrong_input) for an invalid number.
  const results::JobPart& part(int job) const;
  /// Reads the prepared case from its copy, under its original name.
  input::LoadedCase read_case() const;
  std::vector<input::Override> overrides() const;

  /// Reads a variant of a job, without its values.
  Variant read_variant(const input::LoadedCase& base, int number) const;
  /// Reads the surfaces on which LEM samples are evaluated.
  std::vector<lem::Surface> read_surfaces() const;

  /// Folder of the result of a job, and of its lock while it is running.
  std::filesystem::path result_folder(int job) const;
  /// Reads the result of a job; nullopt if the job has not ended, or if the result is that of another job.
  std::optional<results::JobResult> read_result(int job) const;
  /// Returns a line on the result of another job in place of that of `job`; empty if there is none.
  std::string describe_strange(int job) const;
  void write_result(int job, results::JobResult result) const;

  /// Formats the command line that runs or repeats (`what`) the jobs with these numbers.
  std::string format_how(const char* what, const std::vector<int>& jobs) const;

 private:
  std::filesystem::path folder_;  ///< absolute path
  results::StudyJobs jobs_;
  std::string hash_;
};

/// Formats 3, 5, 6, 7 as "3,5-7".
std::string write_ranges(const std::vector<int>& numbers);

/// Runs a job and stores its result when it ends. A job that ended without a failure is kept; of one with failures
/// only these are repeated. Returns the failure of variants or samples, which is stored as well. Throws what JobFolder
/// throws, Error (folder_exists) while another process runs the same job, Error (interrupted) and Error
/// (cannot_write); the job then counts as missing, and resumes from its runs.
std::optional<Error> calculate_job(const std::filesystem::path& folder, int job, int threads, Progress* progress);

struct JobStates {
  int count = 0;
  std::vector<int> missing, failed;  ///< numbers of the jobs
};
/// Throws what JobFolder throws.
JobStates list_jobs(const std::filesystem::path& folder);

/// Writes the tables of the study, bitwise identical to those of one process except for times. If jobs are missing,
/// their runs have rows with the status not started, and LEM samples have no table yet; the failure lists the jobs and
/// how to run them. Throws what JobFolder throws, and Error (interrupted) if no job has ended.
StudyOutcome collect_jobs(const StudyOptions& options);

}  // namespace talus::study
