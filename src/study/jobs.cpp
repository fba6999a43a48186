// SPDX-License-Identifier: MIT
#include "study/jobs.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/lane.hpp"
#include "base/user_file.hpp"
#include "base/version.hpp"
#include "input/echo.hpp"
#include "results/json.hpp"
#include "study/sampling.hpp"
#include "study/study_table.hpp"

namespace talus::study {

namespace {

namespace fs = std::filesystem;

void check_program(const results::StudyJobs& jobs, const fs::path& folder) {
  const auto write = [](const std::string& number, const std::string& source, const std::string& level) {
    return fmt::format("Talus {} (source {}, {})", number, source, level);
  };
  const std::string then = write(jobs.version, jobs.commit, jobs.level);
  const std::string now = write(version, commit, instruction_level);
  if (then != now)
    fail_input(
        "the jobs in '{}' were prepared by {}, and this is {}: results would not be of one program; use that one, or "
        "prepare them again with --overwrite",
        folder.string(), then, now);
}

/// Throws Error (wrong_input) unless the folders of runs have names that a plan makes, and parts and files exist.
void check_names(const results::StudyJobs& jobs, const fs::path& folder) {
  const auto refuse = [&](const std::string& why) {
    fail_input("'{}' {}; prepare the jobs again with --overwrite", (folder / "jobs.json").string(), why);
  };
  if (jobs.files.empty()) refuse("names no copy of the case");
  for (const results::JobVariant& v : jobs.variants) {
    const std::string fault = find_name_fault(v.folder);
    if (!fault.empty() || is_reserved_name(v.folder))
      refuse(fmt::format("names the folder '{}' for a run: {}", v.folder,
                         fault.empty() ? "the study has files of that name" : fault));
  }
  const bool has_runs = jobs.work == results::JobWork::runs;
  for (const results::JobPart& part : jobs.jobs)
    if (part.first < 0 || part.end <= part.first || (has_runs && part.end > static_cast<int>(jobs.variants.size())))
      refuse(
          fmt::format("has a job of the runs {} to {}, and {} runs", part.first, part.end - 1, jobs.variants.size()));
}

}  // namespace

std::string write_ranges(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

JobFolder::JobFolder(const fs::path& folder) {
  std::error_code unknown;
  folder_ = fs::weakly_canonical(folder, unknown);
  const fs::path file = folder_ / "jobs.json";
  std::optional<results::StudyJobs> jobs;
  if (fs::is_regular_file(file, unknown)) jobs = results::read_file<results::StudyJobs>(file);
  if (!jobs || jobs->jobs.empty())
    fail_input("there are no jobs in '{0}': it has no jobs.json; talus study CASE --prepare {0} writes them",
               folder.string());
  jobs_ = std::move(*jobs);
  check_program(jobs_, folder);
  check_names(jobs_, folder);
  for (const results::JobFile& f : jobs_.files)
    if (hash_text(read_user_file(join_path(folder_, f.name), largest_file::mesh)) != f.hash)
      fail_input("'{}' is not as it was when the jobs were prepared; prepare them again with --overwrite",
                 join_path(folder, f.name).string());
  hash_ = hash_text(read_user_file(file, largest_file::result));
}

const results::JobPart& JobFolder::part(int job) const {
  if (job < 0 || job >= count())
    fail_input("there is no job {} in '{}'; its jobs are 0 to {}", job, folder_.string(), count() - 1);
  return jobs_.jobs[static_cast<std::size_t>(job)];
}

std::vector<input::Override> JobFolder::overrides() const {
  std::vector<input::Override> list;
  for (const results::JobChange& c : jobs_.changes) list.push_back({c.key, c.value});
  return list;
}

input::LoadedCase JobFolder::read_case() const {
  return input::read_case(join_path(folder_, jobs_.files.front().name).string(), overrides());
}

Variant JobFolder::read_variant(const input::LoadedCase& base, int number) const {
  const results::JobVariant& out = jobs_.variants.at(static_cast<std::size_t>(number));
  Variant variant;
  variant.name = out.folder;
  variant.label = out.label;
  for (const results::JobChange& c : out.changes) variant.changes.push_back({c.key, c.value});
  variant.loaded = input::read_case_text(base.text, base.file, variant.changes);
  variant.input_hash = input::hash_input(variant.loaded.echo, variant.loaded.data);
  return variant;
}

std::vector<lem::Surface> JobFolder::read_surfaces() const {
  const auto out = results::find_file<results::JobSurfaces>(folder_ / "surfaces.json");
  if (!out || out->study != hash_)
    fail_input("'{}' is not there or belongs to other jobs; prepare them again with --overwrite",
               (folder_ / "surfaces.json").string());
  std::vector<lem::Surface> surfaces;
  for (const results::JobSurface& s : out->surfaces) {
    lem::Surface& surface = surfaces.emplace_back();
    surface.name = s.name;
    if (s.circle) surface.circle = lem::Circle{{(*s.circle)[0], (*s.circle)[1]}, (*s.circle)[2]};
    for (const auto& p : s.line) surface.line.push_back({p[0], p[1]});
    surface.from = s.from;
    surface.to = s.to;
  }
  return surfaces;
}

fs::path JobFolder::result_folder(int job) const {
  return folder_ / "jobs" / std::to_string(job);
}

std::optional<results::JobResult> JobFolder::read_result(int job) const {
  auto result = results::find_file<results::JobResult>(result_folder(job) / "result.json");
  const results::JobPart& own = part(job);
  const auto size = static_cast<std::size_t>(own.end - own.first);
  if (!result || result->study != hash_ || result->job != job) return std::nullopt;
  const bool is_whole = jobs_.work == results::JobWork::runs
                            ? result->variants.size() == size && result->codes.size() == size
                            : result->code != 0 || result->factors.size() == size;
  return is_whole ? result : std::nullopt;
}

std::string JobFolder::describe_strange(int job) const {
  const fs::path file = result_folder(job) / "result.json";
  const auto result = results::find_file<results::JobResult>(file);
  if (!result || result->job == job || result->study != hash_) return "";
  return fmt::format("\n'{}' is the result of job {} and was not taken", file.string(), result->job);
}

void JobFolder::write_result(int job, results::JobResult result) const {
  result.study = hash_;
  result.job = job;
  results::write_file(result_folder(job) / "result.json", result, -1, "the job can be repeated");
}

std::string JobFolder::format_how(const char* what, const std::vector<int>& jobs) const {
  const std::string each = jobs.size() == 1 ? std::to_string(jobs.front()) : "K for each K";
  return fmt::format("to {} {}, in '{}': sbatch --array={} jobs.slurm, or talus study . --job {}", what,
                     jobs.size() == 1 ? "it" : "them", folder_.string(), write_ranges(jobs), each);
}

namespace {

/// Runs the variants of a job: finished ones are kept, the others are resumed or started.
std::optional<Error> calculate_own_runs(const JobFolder& folder, const results::JobPart& part, StudyOptions options,
                                        results::JobResult& result) {
  const input::LoadedCase base = folder.read_case();
  StudyPlan plan;
  for (int i = part.first; i < part.end; ++i) plan.variants.push_back(folder.read_variant(base, i));
  options.resume = true;
  check_variants(plan, options);
  const std::vector<StudyRow> rows = run_variants(plan, options, [](const auto&) {});
  for (const StudyRow& row : rows) {
    // A variant that was interrupted, or is being run elsewhere, has not ended.
    if (row.summary.status == results::VariantStatus::not_started || row.code == ExitCode::interrupted)
      throw Error(ExitCode::interrupted, "interrupted; the same job continues from here");
    if (row.code == ExitCode::folder_exists) throw Error(row.code, row.summary.reason);
    result.variants.push_back(row.summary);
    result.codes.push_back(static_cast<int>(row.code));
  }
  return find_failure(rows);
}

std::optional<Error> calculate_own_samples(const JobFolder& folder, const results::JobPart& part,
                                           const StudyOptions& options, results::JobResult& result) {
  const input::LoadedCase base = folder.read_case();
  const std::vector<input::Override> overrides = folder.overrides();
  const SampleSet set = draw_samples(base);
  const SliceFactor slices(base, overrides, set.sampled, folder.read_surfaces());
  try {
    result.factors =
        find_factors(slices, set, static_cast<std::size_t>(part.first), static_cast<std::size_t>(part.end), options);
  } catch (const Error& error) {
    if (error.code() != ExitCode::wrong_input) throw;
    result.reason = error.what();  // a sample that is no valid case; repeating the job would not change that
    return error;
  }
  return std::nullopt;
}

/// Results of the jobs, in their order.
struct Gathered {
  JobStates states;
  std::vector<std::optional<results::JobResult>> results;
  double seconds = 0;
};

Gathered gather(const JobFolder& folder) {
  Gathered all;
  all.states.count = folder.count();
  for (int job = 0; job < folder.count(); ++job) {
    const auto& result = all.results.emplace_back(folder.read_result(job));
    if (!result) all.states.missing.push_back(job);
    if (result && result->code != 0) all.states.failed.push_back(job);
    if (result) all.seconds += result->seconds;
  }
  return all;
}

/// Returns the rows of the finished jobs, and empty rows for the others.
std::vector<StudyRow> gather_rows(const JobFolder& folder, const StudyPlan& plan, const Gathered& all) {
  std::vector<StudyRow> rows = begin_rows(plan);
  for (std::size_t job = 0; job < all.results.size(); ++job) {
    if (!all.results[job]) continue;
    const results::JobPart& part = folder.part(static_cast<int>(job));
    for (int i = part.first; i < part.end; ++i) {
      const auto at = static_cast<std::size_t>(i), own = static_cast<std::size_t>(i - part.first);
      StudyRow& row = rows.at(at);
      row.summary = all.results[job]->variants[own];
      row.code = static_cast<ExitCode>(all.results[job]->codes[own]);
      const std::filesystem::path run = join_name(folder.folder(), plan.variants[at].name);
      row.result = load_variant(run);
      if (row.result && row.result->provenance.input_hash != plan.variants[at].input_hash) row.result.reset();
      if (row.summary.status == results::VariantStatus::finished) check_row(run, row);
    }
  }
  return rows;
}

/// Returns the factors of all samples. Throws Error if a job failed, since there are no statistics then, as in one
/// process.
KnownFactors gather_factors(const JobFolder& folder, const Gathered& all) {
  KnownFactors known;
  known.seconds = all.seconds;
  std::string reasons;
  for (const int job : all.states.failed)
    reasons += fmt::format("\n  job {}: {}", job, all.results[static_cast<std::size_t>(job)]->reason);
  if (!reasons.empty()) {
    const auto code = static_cast<ExitCode>(all.results[static_cast<std::size_t>(all.states.failed.front())]->code);
    throw Error(code, "{} of {} jobs failed:{}", all.states.failed.size(), folder.count(), reasons);
  }
  for (const auto& result : all.results)
    known.factors.insert(known.factors.end(), result->factors.begin(), result->factors.end());
  return known;
}

/// Returns a line for every missing job in whose place the result of another one is found.
std::string describe_strange(const JobFolder& folder, const JobStates& states) {
  std::string lines;
  for (const int job : states.missing) lines += folder.describe_strange(job);
  return lines;
}

/// Returns the error on missing or failed jobs; `failure` is that of the runs.
std::optional<Error> make_states_result(const JobFolder& folder, const JobStates& states,
                                        const std::optional<Error>& failure) {
  std::string failed;
  if (!states.failed.empty())
    failed = fmt::format("\n{} of {} jobs {} failures: {}; {}", states.failed.size(), states.count,
                         states.failed.size() == 1 ? "has" : "have", write_ranges(states.failed),
                         folder.format_how("repeat", states.failed));
  failed += describe_strange(folder, states);
  if (states.missing.empty())
    return failure ? std::optional(Error(failure->code(), failure->what() + failed)) : failure;
  return Error(ExitCode::interrupted, "{} of {} jobs {} missing: {}; {}{}", states.missing.size(), states.count,
               states.missing.size() == 1 ? "is" : "are", write_ranges(states.missing),
               folder.format_how("calculate", states.missing), failed);
}

}  // namespace

std::optional<Error> calculate_job(const std::filesystem::path& folder, int job, int threads, Progress* progress) {
  const JobFolder jobs(folder);
  const results::JobPart& part = jobs.part(job);
  FolderLock lock(jobs.result_folder(job));
  lock.take();
  const FileList files(jobs.result_folder(job));
  if (const auto there = jobs.read_result(job); there && there->code == 0) return std::nullopt;
  StudyOptions options;
  options.folder = jobs.folder();
  options.threads = threads;
  options.progress = progress;
  const auto start = std::chrono::steady_clock::now();
  results::JobResult result;
  std::optional<Error> failure = jobs.jobs().work == results::JobWork::runs
                                     ? calculate_own_runs(jobs, part, options, result)
                                     : calculate_own_samples(jobs, part, options, result);
  if (failure) result.code = static_cast<int>(failure->code());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  jobs.write_result(job, std::move(result));
  return failure;
}

JobStates list_jobs(const std::filesystem::path& folder) {
  return gather(JobFolder(folder)).states;
}

StudyOutcome collect_jobs(const StudyOptions& options) {
  const JobFolder folder(options.folder);
  const Gathered all = gather(folder);
  std::vector<int> every(static_cast<std::size_t>(folder.count()));
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = static_cast<int>(i);
  if (all.states.missing == every)
    throw Error(ExitCode::interrupted, "none of the {} jobs has ended: there is nothing to collect yet; {}{}",
                every.size(), folder.format_how("calculate", every), describe_strange(folder, all.states));
  if (folder.jobs().work == results::JobWork::slice_samples && !all.states.missing.empty())
    throw Error(*make_states_result(folder, all.states, std::nullopt));
  const input::LoadedCase base = folder.read_case();
  const std::vector<input::Override> overrides = folder.overrides();
  FolderLock lock(folder.folder());
  lock.take();
  const FileList files(folder.folder());
  if (base.data.study.mode != input::StudyMode::sample) {
    StudyPlan plan = plan_study(base, overrides);
    plan.summary.case_file = folder.jobs().case_file;
    const std::vector<StudyRow> rows = gather_rows(folder, plan, all);
    write_study(plan, rows, folder.folder());
    return {write_study_markdown(plan, rows, describe_study(plan, rows)),
            make_states_result(folder, all.states, find_failure(rows))};
  }
  SampleSet set = draw_samples(base);
  SamplingResult result;
  if (is_by_slices(base)) {
    const KnownFactors known = gather_factors(folder, all);
    result.study = begin_sampling(base, options.threads);
    result.study.case_file = result.study.provenance->case_file = folder.jobs().case_file;
    calculate_slices(base, overrides, options, set, &known);
  } else {
    StudyPlan plan = plan_samples(base, overrides, set);
    plan.summary.case_file = folder.jobs().case_file;
    const std::vector<StudyRow> rows = gather_rows(folder, plan, all);
    write_study(plan, rows, folder.folder());
    result.study = make_runs_result(base, plan, rows, all.seconds, set);
    result.failure = make_states_result(folder, all.states, find_failure(rows));
  }
  write_sampling(base, folder.folder(), set, result);
  return {std::move(result.markdown), std::move(result.failure)};
}

}  // namespace talus::study
