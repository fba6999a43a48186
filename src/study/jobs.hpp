// SPDX-License-Identifier: MIT
#pragma once
// The jobs of a prepared study: each is calculated by itself, anywhere, as often as one likes; then they are gathered.

#include <filesystem>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "study/whole_study.hpp"

namespace talus::study {

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
