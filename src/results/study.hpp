// SPDX-License-Identifier: MIT
#pragma once
// Results of a study, study.json: table, status of the variants, extrapolated factors and statistics of samples; and
// the files of a study that is divided into jobs.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "results/back_analysis.hpp"
#include "results/run.hpp"
#include "results/sampling.hpp"

namespace talus::results {

struct StudyKey {
  std::string key, unit;
  std::vector<std::string> values;
};
void describe(Visitor& v, StudyKey& r);

/// One cell of the table: full precision, and rounded for display. Both are empty if the variant has no such result.
struct StudyCell {
  std::string full, shown;
};
void describe(Visitor& v, StudyCell& r);

/// Kind of a column, where it affects the output: ranges over the variants are reported for these kinds, and factors
/// are extrapolated.
enum class ColumnKind { other, governing, factor, runout, displacement, ratio };
template <>
inline constexpr auto words<ColumnKind> = std::array{"other", "governing", "factor", "runout", "displacement", "ratio"};

struct StudyColumn {
  std::string name;              ///< header in the CSV file, `strength_reduction.curve.damping`
  std::string title;             ///< header in the Markdown file, `damping`
  std::string unit;              ///< empty for dimensionless numbers and words
  std::vector<StudyCell> cells;  ///< by variant
  ColumnKind kind = ColumnKind::other;
  std::string by;  ///< method or criterion of a factor of safety
};
void describe(Visitor& v, StudyColumn& r);

enum class VariantStatus { not_started, finished, interrupted, unstable, failed };
template <>
inline constexpr auto words<VariantStatus> = std::array{"not started", "finished", "interrupted", "unstable", "failed"};

struct StudyVariant {
  std::string name, folder;
  VariantStatus status = VariantStatus::not_started;
  std::string reason;  ///< why it did not finish
};
void describe(Visitor& v, StudyVariant& r);

/// One factor, extrapolated to zero of the varied key (docs/manual/study.md).
struct ExtrapolatedFactor {
  std::string criterion, by, variant;  ///< title of the column; method or criterion; values of the other keys
  std::vector<double> sizes, factors;
  double linear = 0;
  std::optional<double> standard_error;
  double finest_pair = 0;
  std::optional<double> order, by_order;
};
void describe(Visitor& v, ExtrapolatedFactor& r);

struct StudyExtrapolation {
  std::string key, unit;
  std::vector<ExtrapolatedFactor> factors;
};
void describe(Visitor& v, StudyExtrapolation& r);

/// Units of display of a study; stress only where samples were drawn.
struct StudyUnits {
  std::string displacement = "mm", length = "m";
  std::optional<std::string> stress;
};
void describe(Visitor& v, StudyUnits& r);

struct StudyResult {
  int format = result_format;
  std::string title, case_file, mode, reference;
  std::vector<StudyKey> vary;
  std::vector<StudyColumn> columns;
  std::vector<StudyVariant> variants;
  std::vector<std::string> notes;
  StudyUnits units;
  std::optional<StudyExtrapolation> extrapolation;
  std::optional<Sampling> sampling;
  std::optional<BackAnalysis> back_analysis;
  // Set for samples evaluated by LEM, which have no RunResult.
  std::optional<Project> project;
  std::optional<Provenance> provenance;
  std::optional<JsonTree> input;
};
void describe(Visitor& v, StudyResult& r);

// Files of a study that is divided into jobs: the list of jobs, the common slip surfaces of the samples, and the result
// of a job.

/// A changed key of the case, as with `--set`.
struct JobChange {
  std::string key, value;
};
void describe(Visitor& v, JobChange& r);

/// A file that the case needs.
struct JobFile {
  std::string name, hash;  ///< name relative to the folder of the jobs
};
void describe(Visitor& v, JobFile& r);

struct JobVariant {
  std::string folder, label;
  std::vector<JobChange> changes;
};
void describe(Visitor& v, JobVariant& r);

enum class JobWork { runs, slice_samples };
template <>
inline constexpr auto words<JobWork> = std::array{"runs", "slice_samples"};

/// Part of one job: the variants or samples with the indices [first, end).
struct JobPart {
  int first = 0, end = 0;
};
void describe(Visitor& v, JobPart& r);

/// jobs.json: the jobs of a study and their input.
struct StudyJobs {
  std::string version, commit, level;  ///< of the program that prepared the jobs
  std::string title, case_file;        ///< case file as named at preparation
  std::vector<JobFile> files;          ///< the copy of the case, then the files that it refers to
  std::vector<JobChange> changes;      ///< by `--set`
  JobWork work = JobWork::runs;
  std::vector<JobVariant> variants;  ///< empty for samples evaluated by LEM
  std::vector<JobPart> jobs;
};
void describe(Visitor& v, StudyJobs& r);

/// A slip surface in full precision.
struct JobSurface {
  std::string name;
  std::optional<std::array<double, 3>> circle;  ///< centre x, y and radius [m]
  std::vector<std::array<double, 2>> line;      ///< vertices of a polyline [m]
  double from = 0, to = 0;                      ///< range of x [m]
};
void describe(Visitor& v, JobSurface& r);

/// surfaces.json: the slip surfaces on which all samples are evaluated; empty if each sample is searched separately.
struct JobSurfaces {
  std::string study;  ///< hash of jobs.json
  std::vector<JobSurface> surfaces;
};
void describe(Visitor& v, JobSurfaces& r);

/// Result of a job; the file is written after the whole part of the job has ended.
struct JobResult {
  std::string study;                   ///< hash of jobs.json
  int job = -1;                        ///< index of the job
  double seconds = 0;                  ///< [s]
  int code = 0;                        ///< exit code of the most severe failure; 0 if there is none
  std::string reason;                  ///< message, if samples evaluated by LEM failed
  std::vector<StudyVariant> variants;  ///< for runs: status of each
  std::vector<int> codes;              ///< for runs: exit code of each
  std::vector<double> factors;         ///< for samples evaluated by LEM; NaN where a sample has no factor
};
void describe(Visitor& v, JobResult& r);

}  // namespace talus::results
