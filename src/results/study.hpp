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
void describe(auto& v, As<StudyKey> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("values", r.values, {"", "values"});
}

/// One cell of the table: full precision, and rounded for display. Both are empty if the variant has no such result.
struct StudyCell {
  std::string full, shown;
};
void describe(auto& v, As<StudyCell> auto& r) {
  v.key("full", r.full, {"", "in full, in the unit of its column"});
  v.key("shown", r.shown, {"", "as people read it"});
}

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
void describe(auto& v, As<StudyColumn> auto& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("cells", r.cells, {"", "cells, one for each variant"});
  v.key("kind", r.kind, {"", "what it is of"});
  v.key("by", r.by, {"", "method or criterion of a factor of safety"});
}

enum class VariantStatus { not_started, finished, interrupted, unstable, failed };
template <>
inline constexpr auto words<VariantStatus> = std::array{"not started", "finished", "interrupted", "unstable", "failed"};

struct StudyVariant {
  std::string name, folder;
  VariantStatus status = VariantStatus::not_started;
  std::string reason;  ///< why it did not finish
};
void describe(auto& v, As<StudyVariant> auto& r) {
  v.key("name", r.name, {"", "name"});
  v.key("folder", r.folder, {"", "folder"});
  v.key("status", r.status, {"", "how it went"});
  v.key("reason", r.reason, {"", "why it is not finished"});
}

/// One factor, extrapolated to zero of the varied key (docs/manual/study.md).
struct ExtrapolatedFactor {
  std::string criterion, by, variant;  ///< title of the column; method or criterion; values of the other keys
  std::vector<double> sizes, factors;
  double linear = 0;
  std::optional<double> standard_error;
  double finest_pair = 0;
  std::optional<double> order, by_order;
};
void describe(auto& v, As<ExtrapolatedFactor> auto& r) {
  v.key("criterion", r.criterion, {"", "factor"});
  v.key("by", r.by, {"", "method or criterion"});
  v.key("variant", r.variant, {"", "other keys"});
  v.key("sizes", r.sizes, {"", "values of the key"});
  v.key("factors", r.factors, {"", "factors"});
  v.key("linear", r.linear, {"", "line through all"});
  v.key("standard_error", r.standard_error, {"", "standard error of it"});
  v.key("finest_pair", r.finest_pair, {"", "line through the finest two"});
  v.key("order", r.order, {"", "order p"});
  v.key("by_order", r.by_order, {"", "with order p"});
}

struct StudyExtrapolation {
  std::string key, unit;
  std::vector<ExtrapolatedFactor> factors;
};
void describe(auto& v, As<StudyExtrapolation> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("factors", r.factors, {"", "factors"});
}

/// Units of display of a study; stress only where samples were drawn.
struct StudyUnits {
  std::string displacement = "mm", length = "m";
  std::optional<std::string> stress;
};
void describe(auto& v, As<StudyUnits> auto& r) {
  v.key("displacement", r.displacement, {"", "unit of displacements"});
  v.key("length", r.length, {"", "unit of lengths"});
  v.maybe("stress", r.stress, {"", "unit of stresses"});
}

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
void describe(auto& v, As<StudyResult> auto& r) {
  v.key("format", r.format, {"", "version of this file"});
  v.key("title", r.title, {"", "title"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("mode", r.mode, {"", "how values were combined"});
  v.key("reference", r.reference, {"", "variant that displacements are divided by"});
  v.key("vary", r.vary, {"", "keys that were varied"});
  v.key("columns", r.columns, {"", "table, column by column"});
  v.key("variants", r.variants, {"", "how each variant went"});
  v.key("notes", r.notes, {"", "notes"});
  v.key("units", r.units, {"", "units of display"});
  v.maybe("extrapolation", r.extrapolation, {"", "factors extrapolated over a key"});
  v.maybe("sampling", r.sampling, {"", "uncertain numbers"});
  v.maybe("back_analysis", r.back_analysis, {"", "value of a key at which a result reaches its target"});
  v.maybe("project", r.project, {"", "title block"});
  v.maybe("provenance", r.provenance, {"", "program, machine and input"});
  v.maybe("input", r.input, {"", "every key of the case"});
}

// Files of a study that is divided into jobs: the list of jobs, the common slip surfaces of the samples, and the result
// of a job.

/// A changed key of the case, as with `--set`.
struct JobChange {
  std::string key, value;
};
void describe(auto& v, As<JobChange> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("value", r.value, {"", "its value as TOML"});
}

/// A file that the case needs.
struct JobFile {
  std::string name, hash;  ///< name relative to the folder of the jobs
};
void describe(auto& v, As<JobFile> auto& r) {
  v.key("name", r.name, {"", "file"});
  v.key("hash", r.hash, {"", "hash of its content"});
}

struct JobVariant {
  std::string folder, label;
  std::vector<JobChange> changes;
};
void describe(auto& v, As<JobVariant> auto& r) {
  v.key("folder", r.folder, {"", "folder"});
  v.key("label", r.label, {"", "name"});
  v.key("changes", r.changes, {"", "what it changes in the case"});
}

enum class JobWork { runs, slice_samples };
template <>
inline constexpr auto words<JobWork> = std::array{"runs", "slice_samples"};

/// Part of one job: the variants or samples with the indices [first, end).
struct JobPart {
  int first = 0, end = 0;
};
void describe(auto& v, As<JobPart> auto& r) {
  v.key("first", r.first, {"", "first variant or sample, counted from 0"});
  v.key("end", r.end, {"", "the one after the last"});
}

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
void describe(auto& v, As<StudyJobs> auto& r) {
  v.key("version", r.version, {"", "version of the program"});
  v.key("commit", r.commit, {"", "its source"});
  v.key("level", r.level, {"", "its instruction set"});
  v.key("title", r.title, {"", "title"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("files", r.files, {"", "copies of the case and of the files that it names"});
  v.key("changes", r.changes, {"", "changes of the case"});
  v.key("work", r.work, {"", "what a job calculates"});
  v.key("jobs", r.jobs, {"", "the part of each job"});
  v.key("variants", r.variants, {"", "the runs"});
}

/// A slip surface in full precision.
struct JobSurface {
  std::string name;
  std::optional<std::array<double, 3>> circle;  ///< centre x, y and radius [m]
  std::vector<std::array<double, 2>> line;      ///< vertices of a polyline [m]
  double from = 0, to = 0;                      ///< range of x [m]
};
void describe(auto& v, As<JobSurface> auto& r) {
  v.key("name", r.name, {"", "name"});
  v.key("circle", r.circle, {"m", "centre and radius"});
  v.key("line", r.line, {"m", "points of a polyline"});
  v.key("from", r.from, {"m", "x of its left end"});
  v.key("to", r.to, {"m", "x of its right end"});
}

/// surfaces.json: the slip surfaces on which all samples are evaluated; empty if each sample is searched separately.
struct JobSurfaces {
  std::string study;  ///< hash of jobs.json
  std::vector<JobSurface> surfaces;
};
void describe(auto& v, As<JobSurfaces> auto& r) {
  v.key("study", r.study, {"", "hash of the list of jobs"});
  v.key("surfaces", r.surfaces, {"", "slip surfaces"});
}

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
void describe(auto& v, As<JobResult> auto& r) {
  v.key("study", r.study, {"", "hash of the list of jobs"});
  v.key("job", r.job, {"", "number of the job"});
  v.key("seconds", r.seconds, {"s", "wall time"});
  v.key("code", r.code, {"", "exit code of the gravest failure"});
  v.key("reason", r.reason, {"", "why samples have no result"});
  v.key("variants", r.variants, {"", "how each run ended"});
  v.key("codes", r.codes, {"", "exit code of each run"});
  v.key("factors", r.factors, {"", "factor of safety of each sample"});
}

}  // namespace talus::results
