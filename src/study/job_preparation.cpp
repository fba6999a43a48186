// SPDX-License-Identifier: MIT
// Plans the jobs of a study, and writes their folder.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/lane.hpp"
#include "base/user_file.hpp"
#include "base/version.hpp"
#include "input/read.hpp"
#include "results/json.hpp"
#include "run/common/run_folder.hpp"
#include "study/jobs.hpp"
#include "study/sampling.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

/// Schedulers allow about a thousand jobs at once.
constexpr int most_jobs = 1000;
/// Fewest LEM samples that are worth a job: on stored surfaces, and with a search for each sample.
constexpr int quick_samples = 1000, searched_samples = 100;
/// Jobs of an array that Slurm runs at a time.
constexpr int most_at_once = 100;

/// The study as one process would run it.
struct Planned {
  StudyPlan plan;  ///< of runs
  std::optional<SampleSet> samples;
  bool by_slices = false;
  int worth = 1;  ///< default number of variants or samples of a job

  int count() const { return static_cast<int>(by_slices ? samples->size() : plan.variants.size()); }
};

Planned plan_work(const input::LoadedCase& base, const std::vector<input::Override>& overrides) {
  Planned planned;
  if (base.data.study.mode == input::StudyMode::sample) {
    planned.samples = draw_samples(base);
    planned.by_slices = is_by_slices(base);
    if (!planned.by_slices) planned.plan = plan_samples(base, overrides, *planned.samples);
    if (planned.by_slices)
      planned.worth =
          SliceNumbers(base, overrides, planned.samples->sampled).changes_section() ? searched_samples : quick_samples;
  } else {
    planned.plan = plan_study(base, overrides);
  }
  return planned;
}

std::vector<results::JobPart> cut_work(int count, int asked, int worth) {
  const long jobs = std::clamp(asked > 0 ? asked : std::min((count + worth - 1) / worth, most_jobs), 1, count);
  std::vector<results::JobPart> parts;
  for (long k = 0; k < jobs; ++k)
    parts.push_back({static_cast<int>(k * count / jobs), static_cast<int>((k + 1) * count / jobs)});
  return parts;
}

std::vector<results::JobChange> make_changes_result(const std::vector<input::Override>& overrides) {
  std::vector<results::JobChange> changes;
  for (const input::Override& o : overrides) changes.push_back({o.key, o.value});
  return changes;
}

std::vector<std::string> list_all_files(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                                        const Planned& planned) {
  std::vector<std::string> names = input::list_files(base.text, overrides);
  for (const Variant& v : planned.plan.variants)
    for (const std::string& name : input::list_files(base.text, v.changes))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

/// Copy of the case and of the files that it names in the folder of the jobs, with the same relative paths. A file
/// with an absolute path is not copied.
class CaseCopy {
 public:
  CaseCopy(const input::LoadedCase& base, const std::vector<std::string>& names) {
    const fs::path home = fs::absolute(base.file).parent_path().lexically_normal();
    std::vector<fs::path> inside;
    long up = 0;
    for (const fs::path path : names) {
      if (path.is_absolute()) continue;
      inside.push_back(path.lexically_normal());
      up = std::max(up, static_cast<long>(std::count(inside.back().begin(), inside.back().end(), "..")));
    }
    fs::path place = "case";
    const long depth = std::distance(home.begin(), home.end());
    for (auto part = std::next(home.begin(), std::max(0L, depth - up)); part != home.end(); ++part) place /= *part;
    add(place / "case.toml", base.text);
    for (fs::path path : inside) {
      if (fs::is_directory(home / path)) path /= run::end_state_file;
      std::string text;
      const auto fault = try_user_file(home / path, largest_file::mesh, text);
      if (fault && !fault->is_missing) fail_input("cannot read '{}': {}", (home / path).string(), fault->why);
      if (!fault) add((place / path).lexically_normal(), std::move(text));
    }
  }

  std::vector<results::JobFile> tell() const {
    std::vector<results::JobFile> out;
    for (const auto& [name, text] : files_) out.push_back({name, hash_text(text)});
    return out;
  }

  void write(const fs::path& folder) const {
    for (const auto& [name, text] : files_) {
      const fs::path file = join_path(folder, name);
      make_folder(file.parent_path());
      write_atomically(file, text);
    }
  }

 private:
  void add(const fs::path& name, std::string text) { files_.emplace_back(name.string(), std::move(text)); }

  std::vector<std::pair<std::string, std::string>> files_;  ///< name and content, the case first
};

results::JobSurfaces make_surfaces_result(const std::vector<lem::Surface>& surfaces, const std::string& study) {
  results::JobSurfaces out;
  out.study = study;
  for (const lem::Surface& s : surfaces) {
    results::JobSurface& surface = out.surfaces.emplace_back();
    surface.name = s.name;
    if (s.circle) surface.circle = {s.circle->centre[0], s.circle->centre[1], s.circle->radius};
    surface.line = s.line;
    surface.from = s.from;
    surface.to = s.to;
  }
  return out;
}

std::string write_script(int jobs) {
  return fmt::format(R"(#!/bin/bash
# The jobs of this folder for Slurm. In this folder: `sbatch jobs.slurm`, then `talus study . --collect`.
# `sbatch --array=3,5-7 jobs.slurm` repeats some. What your cluster asks for (partition, time, memory) goes below as #SBATCH lines;
# TALUS=/path/to/talus names a program that is not in the PATH.
#SBATCH --job-name=talus
#SBATCH --array=0-{}%{}
#SBATCH --cpus-per-task=1
#SBATCH --output=jobs/%a.log
export TALUS_LEVEL={}
exec "${{TALUS:-talus}}" study . --job "$SLURM_ARRAY_TASK_ID" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)",
                     jobs - 1, most_at_once, instruction_level);
}

/// Returns true if the folder already has the same jobs. Throws Error (wrong_input) if it has others.
bool has_same(const fs::path& folder, const std::string& text) {
  if (!fs::exists(folder / "jobs.json")) return false;
  if (read_user_file(folder / "jobs.json", largest_file::result) != text)
    fail_input(
        "'{}' holds the jobs of another case, study, number of jobs or program; continue with the same, or start anew "
        "with --overwrite",
        folder.string());
  return true;
}

}  // namespace

void prepare_jobs(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                  const JobOptions& options) {
  const fs::path& folder = options.study.folder;
  Planned planned = plan_work(base, overrides);
  const CaseCopy copy(base, list_all_files(base, overrides, planned));
  results::StudyJobs jobs;
  jobs.version = version;
  jobs.commit = commit;
  jobs.level = instruction_level;
  jobs.title = base.data.title;
  jobs.case_file = base.file;
  jobs.files = copy.tell();
  jobs.changes = make_changes_result(overrides);
  jobs.work = planned.by_slices ? results::JobWork::slice_samples : results::JobWork::runs;
  for (const Variant& v : planned.plan.variants)
    jobs.variants.push_back({v.name, v.label, make_changes_result(v.changes)});
  jobs.jobs = cut_work(planned.count(), options.jobs, planned.worth);
  const std::string text = results::to_json(jobs).dump(1) + "\n";

  check_folder(base, planned.plan, options.study,
               "give another one, replace it with --overwrite, or continue with --resume");
  FolderLock lock(folder);
  lock.take_existing();
  if (options.study.resume && has_same(folder, text)) return;
  check_variants(planned.plan, options.study);
  std::vector<lem::Surface> surfaces;
  if (planned.by_slices) surfaces = begin_slices(base, overrides, options.study, *planned.samples)->list_surfaces();
  if (options.study.progress != nullptr) options.study.progress->clear();
  lock.take();
  const auto files = open_folder(planned.plan, options.study);
  make_folder(folder / "jobs");
  for (std::size_t k = 0; k < jobs.jobs.size(); ++k) files->add_folder(fmt::format("jobs/{}", k));
  copy.write(folder);
  if (planned.by_slices)
    results::write_file(folder / "surfaces.json", make_surfaces_result(surfaces, hash_text(text)), -1);
  write_atomically(folder / "jobs.slurm", write_script(static_cast<int>(jobs.jobs.size())));
  write_atomically(folder / "jobs.json", text);  // last, as it marks the folder as prepared
}

}  // namespace talus::study
