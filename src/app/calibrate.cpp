// SPDX-License-Identifier: MIT
// `talus calibrate CASE`: parameters of soils from measured curves.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "base/encoding.hpp"
#include "base/interrupt.hpp"
#include "input/read.hpp"
#include "laboratory/run_calibration.hpp"
#include "report/report.hpp"

namespace talus::app {
namespace {

struct CalibrateCommand {
  CaseOptions input;
  laboratory::CalibrationRun run;
  bool quiet = false, no_report = false;
};

void calibrate(CalibrateCommand& command) {
  laboratory::CalibrationRun& run = command.run;
  run.overrides = command.input.parse_overrides();
  const input::LoadedCase loaded =
      input::read_case(command.input.file, run.overrides, input::CaseScope::whole_or_tests);
  if (run.folder.empty()) run.folder = std::filesystem::path(command.input.file).stem().string() + "_calibration";
  catch_interrupts();
  Progress progress(!command.quiet);
  run.options.progress = &progress;
  const results::Calibration calibration = laboratory::run_calibration(loaded, run);
  if (!command.no_report) report::write_report(run.folder);
  if (command.quiet) return;
  print(stdout,
        fmt::format(
            "{}Tables are in {}{}\n", laboratory::write_calibration_digest(calibration),
            (run.folder / "calibration").string(),
            command.no_report ? "" : fmt::format("; open {} in a browser", (run.folder / "report.html").string())));
}

}  // namespace

void add_calibrate(CLI::App& app) {
  const Command command(app, "calibrate", "Fit soil parameters to measured curves of element tests");
  const auto options = std::make_shared<CalibrateCommand>();
  options->input.add_to(command);
  command.take("-o,--output,--out", options->run.folder,
               "Folder for the results (default: the case's name with _calibration)");
  command.take("--threads", options->run.options.threads, "Threads to use (default: all cores)").positive(most_threads);
  command.take("--pictures", options->run.pictures, "Format of the pictures of the tests (default: svg)")
      .one_of({"svg", "png"});
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.act([options] { calibrate(*options); });
}

}  // namespace talus::app
