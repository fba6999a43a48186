// SPDX-License-Identifier: MIT
#pragma once
// A study cut into jobs that are calculated anywhere: the list of jobs, the surfaces that samples are evaluated on, and
// what a job has found.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/study.hpp"

namespace talus::results {

/// A change of the case, as --set has it.
struct JobChange {
  std::string key, value;
};
template <class V, As<JobChange> R>
void describe(V& v, R& r) {
  v.key("key", r.key, {"", "key"});
  v.key("value", r.value, {"", "its value as TOML"});
}

/// A file of the case.
struct JobFile {
  std::string name, hash;  ///< the name is relative to the folder of the jobs
};
template <class V, As<JobFile> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "file"});
  v.key("hash", r.hash, {"", "hash of its content"});
}

/// One run: a variant of the case, or a sample.
struct JobVariant {
  std::string folder, label;
  std::vector<JobChange> changes;
};
template <class V, As<JobVariant> R>
void describe(V& v, R& r) {
  v.key("folder", r.folder, {"", "folder"});
  v.key("label", r.label, {"", "name"});
  v.key("changes", r.changes, {"", "what it changes in the case"});
}

/// What a job calculates.
enum class JobWork { runs, slice_samples };
template <>
inline constexpr auto words<JobWork> =
    std::array{Word{JobWork::runs, "runs"}, Word{JobWork::slice_samples, "slice_samples"}};

/// The part of one job: the variants or samples from `first` to before `end`, counted from 0.
struct JobPart {
  int first = 0, end = 0;
};
template <class V, As<JobPart> R>
void describe(V& v, R& r) {
  v.key("first", r.first, {"", "first variant or sample, counted from 0"});
  v.key("end", r.end, {"", "the one after the last"});
}

/// jobs.json.
struct StudyJobs {
  int format = 1;
  std::string version, commit, level;  ///< of the program that prepared them
  std::string title, case_file;        ///< the file as it was named then
  std::vector<JobFile> files;          ///< the copy of the case, then the files that it names
  std::vector<JobChange> changes;      ///< of --set
  JobWork work = JobWork::runs;
  std::vector<JobVariant> variants;  ///< empty for samples by slices
  std::vector<JobPart> jobs;
};
template <class V, As<StudyJobs> R>
void describe(V& v, R& r) {
  v.key("format", r.format, {"", "version of this file"});
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

/// A slip surface to the last bit.
struct JobSurface {
  std::string name;
  std::optional<std::array<double, 3>> circle;  ///< centre and radius [m]
  std::vector<std::array<double, 2>> line;      ///< [m]
  double from = 0, to = 0;                      ///< [m]
};
template <class V, As<JobSurface> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "name"});
  v.key("circle", r.circle, {"m", "centre and radius"});
  v.key("line", r.line, {"m", "points of a polyline"});
  v.key("from", r.from, {"m", "x of its left end"});
  v.key("to", r.to, {"m", "x of its right end"});
}

/// surfaces.json: those that samples by slices are evaluated on; none where every sample is searched for itself.
struct JobSurfaces {
  std::string study;  ///< hash of its jobs.json
  std::vector<JobSurface> surfaces;
};
template <class V, As<JobSurfaces> R>
void describe(V& v, R& r) {
  v.key("study", r.study, {"", "hash of the list of jobs"});
  v.key("surfaces", r.surfaces, {"", "slip surfaces"});
}

/// What a job has found; it exists when all of its part has ended.
struct JobResult {
  std::string study;                   ///< hash of its jobs.json
  int job = -1;                        ///< its number
  double seconds = 0;                  ///< [s]
  int code = 0;                        ///< exit code of the gravest failure; 0: none
  std::string reason;                  ///< of the samples by slices, where the job failed
  std::vector<StudyVariant> variants;  ///< of runs: how each ended
  std::vector<int> codes;              ///< and its exit code
  std::vector<double> factors;         ///< of samples by slices; NaN where a sample has none
};
template <class V, As<JobResult> R>
void describe(V& v, R& r) {
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
