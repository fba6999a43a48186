// SPDX-License-Identifier: MIT
// `talus find KEY CASE --target NAME=VALUE`: back-analysis, the value of a key at which a result reaches its target.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "study/back_analysis.hpp"

namespace talus::app {
namespace {

struct FindCommand {
  CaseOptions input;
  study::BackAnalysisRequest request;
  std::vector<std::string> targets;
  std::optional<double> tolerance;
  std::string folder;
  int threads = 0;
  bool resume = false, overwrite = false, quiet = false, no_report = false;
};

void find(FindCommand command) {
  const std::vector<input::Override> overrides = command.input.parse_overrides();
  const input::LoadedCase base = input::read_case(command.input.file, overrides);
  catch_interrupts();
  Progress progress(!command.quiet);
  study::StudyOptions options;
  options.folder =
      command.folder.empty() ? std::filesystem::path(command.input.file).stem().string() + "_find" : command.folder;
  options.threads = command.threads > 0 ? command.threads : default_threads();
  options.resume = command.resume;
  options.overwrite = command.overwrite;
  options.progress = &progress;
  if (command.tolerance) command.request.tolerance = *command.tolerance;
  command.request.target = command.targets.front();
  command.request.further.assign(command.targets.begin() + 1, command.targets.end());
  study::BackAnalysisOutcome outcome;
  do_and_report(options.folder, !command.no_report,
                [&] { outcome = study::search_key(base, overrides, command.request, options); });
  if (!command.quiet)
    print(stdout, fmt::format("{}\nTables and results are in {}{}\n", outcome.tables, options.folder.string(),
                              command.no_report ? "" : "; open report.html there in a browser"));
  if (outcome.failure) throw Error(*outcome.failure);
}

}  // namespace

void add_find(CLI::App& app) {
  const Command command(app, "find", "Search the value of a key at which a result reaches a target (back-analysis)");
  const auto options = std::make_shared<FindCommand>();
  command.take("key", options->request.key, "The key to vary, written as for --set: materials.clay.cohesion")
      .shown_as("KEY")
      .required();
  options->input.add_to(command);
  command
      .take("--target", options->targets,
            "The result and its value: factor=1.0 for the factor that governs, or a name of [[compare]] as in "
            "lem.spencer=1.3; may be repeated, for the values of several methods side by side")
      .one_each()
      .shown_as("NAME=VALUE")
      .required();
  command
      .take("--from", options->request.from,
            "Smallest value of the key, in its unit or with a unit (default: expanded from the value of the case)")
      .shown_as("VALUE");
  command.take("--to", options->request.to, "Largest value of the key").shown_as("VALUE");
  command.take("--tolerance", options->tolerance,
               "Width of the final bracket relative to the value of the key (default: 0.001)");
  command.take("-o,--output", options->folder, "Folder for the results (default: the case's name with _find)");
  command.take("--threads", options->threads, "Threads to use (default: as many as there are cores)")
      .positive(most_threads);
  const Argument resume =
      command.flag("--resume", options->resume, "Keep the finished runs and resume the interrupted one");
  command.flag("--overwrite", options->overwrite, "Replace results that are in the folder").excludes(resume);
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.act([options] { find(*options); });
}

}  // namespace talus::app
