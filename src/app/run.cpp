// SPDX-License-Identifier: MIT
// `talus run CASE`: runs a case into its folder.

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "app/progress_lines.hpp"
#include "base/error.hpp"
#include "base/lane.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/ranks.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "run/check_case.hpp"
#include "run/common/run_folder.hpp"
#include "run/digest.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "run/run_case.hpp"

namespace talus::app {
namespace {

struct RunCommand {
  CaseOptions input;
  std::string folder;
  int threads = 0;
  std::string device = "cpu";
  bool resume = false, overwrite = false, quiet = false, no_report = false, strict = false, progress_lines = false,
       live = false;
};

/// Throws Error if, with --strict, a stage did not come to rest as required; called when all results are written.
void refuse_restless(const results::RunResult& result) {
  for (const results::Stage& stage : result.stages.value_or(std::vector<results::Stage>{}))
    if (stage.moving)
      throw Error(ExitCode::unstable,
                  "stage '{}' did not come to rest, which --strict asks for; the results are complete, and their "
                  "warnings say what moved",
                  stage.name);
}

/// Temporary folder of a rank other than the first. These ranks run the same case, and their results are removed with
/// the folder.
class OwnFolder {
 public:
  explicit OwnFolder(run::RunOptions& options) {
    if (get_ranks().rank() == 0) return;
    const std::filesystem::path parent = std::filesystem::temp_directory_path();
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    const std::string name = fmt::format("talus_rank_{}_", host);
    remove_left_over(parent, name);
    folder_ = parent / (name + std::to_string(getpid()));
    // An interrupted run resumes from its files.
    if (options.resume && std::filesystem::exists(options.folder))
      std::filesystem::copy(options.folder, folder_, std::filesystem::copy_options::recursive);
    options.folder = folder_;
  }
  ~OwnFolder() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

 private:
  /// Removes the folders of ranks of this machine that were killed.
  static void remove_left_over(const std::filesystem::path& parent, const std::string& name) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(parent, ignored)) {
      const std::string other = entry.path().filename().string();
      if (other.starts_with(name) && !std::filesystem::exists("/proc/" + other.substr(name.size()), ignored))
        std::filesystem::remove_all(entry.path(), ignored);
    }
  }

  std::filesystem::path folder_;
};

/// Samples functions whose last digits depend on the library and the processor.
std::vector<double> sample_functions() {
  constexpr int samples = 512;
  std::vector<double> values;
  for (int i = 1; i <= samples; ++i) {
    const double x = 0.037 * i;
    for (const double y : {std::exp(-x), std::log(x), std::sin(x), std::cos(x), std::tan(x), std::atan(x),
                           std::pow(x, 0.37), std::cbrt(x), std::tanh(0.1 * x), std::hypot(x, 1.7)})
      values.push_back(y);
  }
  return values;
}

/// Throws Error unless all ranks have the same program and libraries, which determine the last digits of results.
void check_programs() {
  const auto gather = [](const auto& list) {
    Message mine;
    mine.put(list.data(), list.size());
    return get_ranks().gather(mine.bytes(), true);
  };
  const std::string own = fmt::format("{} {} {} {}", version, commit, instruction_level, compiler);
  const std::vector<Bytes> programs = gather(own), functions = gather(sample_functions());
  for (std::size_t r = 1; r < programs.size(); ++r) {
    if (programs[r] != programs[0])
      fail_input("rank {} runs another build of Talus than rank 0; this one is {}", r, own);
    if (functions[r] != functions[0])
      fail_input(
          "rank {} has other last digits of functions than rank 0: the libraries or the processors of their machines "
          "differ",
          r);
  }
}

void run(RunCommand command) {
  join_ranks();
  check_programs();
  const Ranks& ranks = get_ranks();
  if (ranks.rank() > 0) command.quiet = command.no_report = true;
  const input::LoadedCase loaded = input::read_case(command.input.file, command.input.parse_overrides());
  if (!command.quiet)
    for (const std::string& warning : run::list_warnings(loaded)) print(stderr, warning + "\n");
  catch_interrupts();
  std::optional<Progress> own_progress;
  if (command.progress_lines)
    own_progress.emplace(Progress::Listener(write_progress_line));
  else
    own_progress.emplace(!command.quiet);
  Progress& progress = *own_progress;
  run::RunOptions options;
  options.folder =
      command.folder.empty() ? std::filesystem::path(command.input.file).stem().string() + "_results" : command.folder;
  options.threads = command.threads > 0 ? command.threads : ranks.size() > 1 ? 1 : default_threads();
  options.device = run::find_device_kind(command.device);
  options.resume = command.resume;
  options.overwrite = command.overwrite;
  options.progress = &progress;
  options.keeps_present = command.live && ranks.rank() == 0;
  lead_ranks([&] { run::check_folder(loaded, options); });
  const OwnFolder own(options);
  results::RunResult result;
  do_and_report(options.folder, !command.no_report, [&] { result = run::run_case(loaded, options); });
  if (!command.quiet)
    print(stdout, fmt::format("{}Results are in {}{}\n", run::write_digest(result), options.folder.string(),
                              command.no_report ? "" : "; open report.html there in a browser"));
  if (command.strict) refuse_restless(result);
}

}  // namespace

void add_run(CLI::App& app) {
  const Command command(app, "run", "Run a case by all methods that it names, and write results and a report");
  const auto options = std::make_shared<RunCommand>();
  options->input.add_to(command);
  command.take("-o,--output", options->folder, "Folder for the results (default: the case's name with _results)");
  command.take("--threads", options->threads, "Threads to use (default: all cores; one for each rank under mpiexec)")
      .positive(most_threads);
  command.take("--device", options->device, "Device for MPM: cpu (default) or gpu");
  const Argument resume = command.flag("--resume", options->resume, "Resume an interrupted run in the same folder");
  command.flag("--overwrite", options->overwrite, "Replace results that are in the folder").excludes(resume);
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("--strict", options->strict,
               "Exit with code 4 if the soil still moves at the end of a stage with until = \"rest\"");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.flag("--progress-lines", options->progress_lines,
               "Print progress as lines of JSON to standard error, for programs that start runs");
  command.flag("--live", options->live, "Store the results so far during the run, for talus report DIR --data FILE");
  command.act([options] { run(*options); });
}

}  // namespace talus::app
