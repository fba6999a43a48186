// SPDX-License-Identifier: MIT
#include "study/job_folder.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "base/file_name.hpp"
#include "base/hash.hpp"
#include "base/lane.hpp"
#include "base/user_file.hpp"
#include "base/version.hpp"
#include "input/echo.hpp"
#include "results/json.hpp"

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
    throw Error(
        ExitCode::wrong_input,
        fmt::format("the jobs in '{}' were prepared by {}, and this is {}: results would not be of one program; "
                    "use that one, or prepare them again with --overwrite",
                    folder.string(), then, now));
}

/// Folders of runs are those of names that a plan makes; parts and files are there.
void check_names(const results::StudyJobs& jobs, const fs::path& folder) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ExitCode::wrong_input,
                fmt::format("'{}' {}; prepare the jobs again with --overwrite", (folder / "jobs.json").string(), why));
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
    throw Error(
        ExitCode::wrong_input,
        fmt::format("there are no jobs in '{0}': it has no jobs.json; talus study CASE --prepare {0} writes them",
                    folder.string()));
  jobs_ = std::move(*jobs);
  check_program(jobs_, folder);
  check_names(jobs_, folder);
  for (const results::JobFile& f : jobs_.files)
    if (hash_text(read_user_file(join_path(folder_, f.name), largest_file::mesh)) != f.hash)
      throw Error(ExitCode::wrong_input,
                  fmt::format("'{}' is not as it was when the jobs were prepared; prepare them again with --overwrite",
                              join_path(folder, f.name).string()));
  hash_ = hash_text(read_user_file(file, largest_file::result));
}

const results::JobPart& JobFolder::part(int job) const {
  if (job < 0 || job >= count())
    throw Error(ExitCode::wrong_input,
                fmt::format("there is no job {} in '{}'; its jobs are 0 to {}", job, folder_.string(), count() - 1));
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
  variant.input_hash = input::hash_input(variant.loaded.echo);
  return variant;
}

std::vector<lem::Surface> JobFolder::read_surfaces() const {
  const auto out = results::find_file<results::JobSurfaces>(folder_ / "surfaces.json");
  if (!out || out->study != hash_)
    throw Error(ExitCode::wrong_input,
                fmt::format("'{}' is not there or belongs to other jobs; prepare them again with --overwrite",
                            (folder_ / "surfaces.json").string()));
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

}  // namespace talus::study
