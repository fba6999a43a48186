// SPDX-License-Identifier: MIT
// `talus study CASE`: calculates a case for every value that its [study] lists.

#include "study/whole_study.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/closing_report.hpp"
#include "app/commands.hpp"
#include "base/interrupt.hpp"
#include "base/parallel.hpp"

namespace talus::app {
namespace {

struct StudyCommand {
  CaseOptions input;
  std::string folder;
  int threads = 0;
  bool resume = false, overwrite = false, quiet = false, no_report = false;
};

void run_study(const StudyCommand& command) {
  const std::vector<input::Override> overrides = command.input.parse_overrides();
  const input::LoadedCase base = input::read_case(command.input.file, overrides);
  catch_interrupts();
  Progress progress(!command.quiet);
  study::StudyOptions options;
  options.folder =
      command.folder.empty() ? std::filesystem::path(command.input.file).stem().string() + "_study" : command.folder;
  options.threads = command.threads > 0 ? command.threads : default_threads();
  options.resume = command.resume;
  options.overwrite = command.overwrite;
  options.progress = &progress;
  study::StudyOutcome outcome;
  do_and_report(options.folder, !command.no_report,
                [&] { outcome = study::calculate_study(base, overrides, options); });
  if (!command.quiet)
    fmt::print("{}\nTables and results are in {}{}\n", outcome.tables, options.folder.string(),
               command.no_report ? "" : "; open report.html there in a browser");
  if (outcome.failure) throw Error(*outcome.failure);
}

}  // namespace

void add_study(CLI::App& app) {
  const Command command(app, "study", "Calculate a case for every value that its [study] lists");
  const auto options = std::make_shared<StudyCommand>();
  options->input.add_to(command);
  command.take("-o,--output", options->folder, "Folder for the results (default: the case's name with _study)");
  command.take("--threads", options->threads, "Variants to calculate side by side (default: all cores)").positive();
  const Argument resume =
      command.flag("--resume", options->resume, "Keep finished variants and go on with interrupted ones");
  command.flag("--overwrite", options->overwrite, "Replace results that are in the folder").excludes(resume);
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.act([options] { run_study(*options); });
}

}  // namespace talus::app
