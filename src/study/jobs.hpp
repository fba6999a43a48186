// SPDX-License-Identifier: MIT
#pragma once
// The jobs of a prepared study: each is calculated by itself, anywhere, as often as one likes; then they are gathered.

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

// The folder of a study whose jobs are calculated anywhere: the case with its files, the list of jobs, a script for
// Slurm, and the results of the jobs that have ended.

struct JobOptions {
  StudyOptions study;  ///< the folder; with `resume` results of the same jobs are kept
  int jobs = 0;        ///< that the work is cut into; 0: as many as it is worth
};

/// Plans the jobs of a study and writes them. Throws what planning does, Error (folder_exists), Error (wrong_input)
/// when the folder holds other jobs that are to go on; all before anything is written.
void prepare_jobs(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                  const JobOptions& options);

/// A folder that prepare_jobs() has written.
class JobFolder {
 public:
  /// Throws Error (wrong_input) when there are no jobs in it, they are of another version of the program, or a file of
  /// the case has changed.
  explicit JobFolder(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  const results::StudyJobs& jobs() const { return jobs_; }
  int count() const { return static_cast<int>(jobs_.jobs.size()); }
  /// Throws Error (wrong_input) for a number that no job has.
  const results::JobPart& part(int job) const;
  /// The case that was prepared, read from its copy; it is told under the name that it had then.
  input::LoadedCase read_case() const;
  std::vector<input::Override> overrides() const;

  /// A variant of a job, without its values.
  Variant read_variant(const input::LoadedCase& base, int number) const;
  /// Those that samples by slices are evaluated on.
  std::vector<lem::Surface> read_surfaces() const;

  /// Where the job's result is, and its lock while it is calculated.
  std::filesystem::path result_folder(int job) const;
  /// The result of a job; nothing where the job has not ended, or where the result is not its own.
  std::optional<results::JobResult> read_result(int job) const;
  /// A line on the result of another job that stands where that of `job` is expected; empty where it does not.
  std::string describe_strange(int job) const;
  void write_result(int job, results::JobResult result) const;

  /// What a person types to calculate or repeat (`what`) the jobs with these numbers.
  std::string format_how(const char* what, const std::vector<int>& jobs) const;

 private:
  std::filesystem::path folder_;  ///< absolute
  results::StudyJobs jobs_;
  std::string hash_;
};

/// 3, 5, 6, 7 as "3,5-7".
std::string write_ranges(const std::vector<int>& numbers);

/// Calculates a job and keeps what it has found, in one go at its end. A job that has ended without a failure is kept
/// as it is; of one with failures only those are repeated. Returns the failure of variants or samples, which is kept as
/// well. Throws what JobFolder throws, Error (folder_exists) while another process calculates the same job, Error
/// (interrupted), Error (cannot_write): then the job counts as missing, and goes on from where its runs were.
std::optional<Error> calculate_job(const std::filesystem::path& folder, int job, int threads, Progress* progress);

struct JobStates {
  int count = 0;
  std::vector<int> missing, failed;  ///< numbers of the jobs
};
/// Throws what JobFolder throws.
JobStates list_jobs(const std::filesystem::path& folder);

/// Writes the tables of the study, with the bits that one process gives; times differ. With jobs missing, those of runs
/// have rows that were not started, and samples by slices have no table yet: the failure says which jobs, and how they
/// are calculated. Throws what JobFolder throws, and Error (interrupted) when no job has ended.
StudyOutcome collect_jobs(const StudyOptions& options);

}  // namespace talus::study
