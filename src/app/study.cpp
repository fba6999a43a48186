// SPDX-License-Identifier: MIT
// `talus study CASE`: runs a case for every value of its [study], here or in jobs that run anywhere.

#include "study/study.hpp"
#include "base/text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "app/progress_lines.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/ranks.hpp"
#include "study/jobs.hpp"

namespace talus::app {
namespace {

/// Default of --job; not a valid number.
constexpr int no_job = std::numeric_limits<int>::min();

struct StudyCommand {
  CaseOptions input;
  std::string folder, prepared;
  int threads = 0, jobs = 0, job = no_job;
  bool resume = false, overwrite = false, quiet = false, no_report = false, collects = false, progress_lines = false;

  study::StudyOptions make_options(const std::filesystem::path& where, Progress& progress) const {
    study::StudyOptions options;
    options.folder = where;
    options.threads = threads > 0 ? threads : default_threads();
    options.resume = resume;
    options.overwrite = overwrite;
    options.progress = &progress;
    return options;
  }
};

/// Runs `calculate`, which writes the tables into `folder`, then writes the report, and prints the tables.
void print_study(const StudyCommand& command, const std::filesystem::path& folder,
                 const std::function<study::StudyOutcome()>& calculate) {
  study::StudyOutcome outcome;
  do_and_report(folder, !command.no_report, [&] { outcome = calculate(); });
  if (!command.quiet)
    print(stdout, fmt::format("{}\nTables and results are in {}{}\n", outcome.tables, folder.string(),
                              command.no_report ? "" : "; open report.html there in a browser"));
  if (outcome.failure) throw Error(*outcome.failure);
}

void prepare_jobs(const StudyCommand& command) {
  const std::vector<input::Override> overrides = command.input.parse_overrides();
  const input::LoadedCase base = input::read_case(command.input.file, overrides);
  catch_interrupts();
  Progress progress(!command.quiet);
  const study::JobOptions options{command.make_options(command.prepared, progress), command.jobs};
  study::prepare_jobs(base, overrides, options);
  if (command.quiet) return;
  const study::JobStates states = study::list_jobs(command.prepared);
  print(stdout, fmt::format("{} jobs are in {}: there, `sbatch jobs.slurm` or each by `talus study . --job K`, K from "
                            "0 to {}; then `talus study . --collect`\n",
                            states.count, command.prepared, states.count - 1));
}

void calculate_job(const StudyCommand& command) {
  catch_interrupts();
  Progress progress(!command.quiet);
  const int threads = command.threads > 0 ? command.threads : default_threads();
  const std::optional<Error> failure = study::calculate_job(command.input.file, command.job, threads, &progress);
  progress.clear();
  if (failure) throw Error(*failure);
  if (!command.quiet) print(stdout, fmt::format("job {} is done\n", command.job));
}

void collect_jobs(const StudyCommand& command) {
  catch_interrupts();
  Progress progress(!command.quiet);
  const study::StudyOptions options = command.make_options(command.input.file, progress);
  print_study(command, options.folder, [&] { return study::collect_jobs(options); });
}

void run_study(const StudyCommand& command) {
  const std::vector<input::Override> overrides = command.input.parse_overrides();
  const input::LoadedCase base = input::read_case(command.input.file, overrides);
  catch_interrupts();
  std::optional<Progress> own_progress;
  if (command.progress_lines)
    own_progress.emplace(Progress::Listener(write_progress_line));
  else
    own_progress.emplace(!command.quiet);
  Progress& progress = *own_progress;
  const study::StudyOptions options = command.make_options(
      command.folder.empty() ? std::filesystem::path(command.input.file).stem().string() + "_study" : command.folder,
      progress);
  print_study(command, options.folder, [&] { return study::calculate_study(base, overrides, options); });
}

/// Selects the action from the combination of options.
void choose(const StudyCommand& command) {
  const auto refuse = [](const std::string& sentence) { fail_input(sentence); };
  // A job runs alone, even if each rank of a launcher starts one.
  if (const int started = count_started(); started > 1 && command.job == no_job)
    refuse(fmt::format(
        "a study does not run on {} ranks of MPI: prepare its jobs (--prepare) and run each of them (--job K)",
        started));
  std::error_code unknown;
  const bool is_folder = std::filesystem::is_directory(command.input.file, unknown);
  const bool has_jobs = command.collects || command.job != no_job;
  if (command.jobs > 0 && command.prepared.empty())
    refuse("--jobs needs --prepare: it is the number of jobs that --prepare writes");
  if (!has_jobs && is_folder)
    refuse(fmt::format(
        "'{}' is a folder, not a case file; for a folder of jobs give --job K to run a job, or --collect to gather all",
        command.input.file));
  if (!has_jobs) return command.prepared.empty() ? run_study(command) : prepare_jobs(command);
  const std::string word = command.collects ? "--collect" : "--job";
  if (!command.input.sets.empty())
    refuse(fmt::format("--set has no meaning with {}: --prepare has written its changes into the jobs", word));
  if (!is_folder)
    refuse(fmt::format("{} needs the folder that talus study CASE --prepare DIR has written; '{}' is none", word,
                       command.input.file));
  return command.collects ? collect_jobs(command) : calculate_job(command);
}

}  // namespace

void add_study(CLI::App& app) {
  const Command command(app, "study", "Run a case for every value, or every sample, of its [study]");
  const auto options = std::make_shared<StudyCommand>();
  options->input.add_to(command);
  const Argument output =
      command.take("-o,--output", options->folder, "Folder for the results (default: the case's name with _study)");
  command.take("--threads", options->threads, "Runs at the same time (default: as many as there are cores)")
      .positive(most_threads);
  const Argument resume =
      command.flag("--resume", options->resume, "Keep the finished runs and resume the interrupted ones");
  const Argument overwrite =
      command.flag("--overwrite", options->overwrite, "Replace results that are in the folder").excludes(resume);
  const Argument no_report =
      command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  const Argument prepare = command
                               .take("--prepare", options->prepared,
                                     "Only write the jobs of the study into this folder, to be run elsewhere")
                               .shown_as("DIR")
                               .excludes(output)
                               .excludes(no_report);
  command
      .take(
          "--jobs", options->jobs,
          "Number of jobs that --prepare writes (default: one for each run, or for 1,000 samples by limit equilibrium)")
      .positive(std::numeric_limits<int>::max());
  const Argument job = command
                           .take("--job", options->job,
                                 "Run the job with this number, from 0; CASE is the folder that --prepare has written")
                           .shown_as("K")
                           .excludes(output)
                           .excludes(no_report)
                           .excludes(resume)
                           .excludes(overwrite)
                           .excludes(prepare);
  command
      .flag("--collect", options->collects,
            "Gather the results of all jobs; CASE is the folder that --prepare has written")
      .excludes(output)
      .excludes(resume)
      .excludes(overwrite)
      .excludes(prepare)
      .excludes(job);
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.flag("--progress-lines", options->progress_lines,
               "Print progress as lines of JSON to standard error, for programs that start runs");
  command.act([options] { choose(*options); });
}

}  // namespace talus::app
