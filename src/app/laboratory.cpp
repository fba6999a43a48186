// SPDX-License-Identifier: MIT
// `talus calibrate CASE`: parameters of soils from measured curves; `talus point CASE`: element tests of the soils of
// a case, without a mesh.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "input/read.hpp"
#include "laboratory/calibration.hpp"
#include "laboratory/point_test.hpp"
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
  const Command command(
      app, "calibrate",
      "Fit soil parameters to measured curves of element tests, or to monitors of stages of construction");
  const auto options = std::make_shared<CalibrateCommand>();
  options->input.add_to(command);
  command.take("-o,--output,--out", options->run.folder,
               "Folder for the results (default: the case's name with _calibration)");
  command.take("--threads", options->run.options.threads, "Threads to use (default: all cores)").positive(most_threads);
  command.take("--pictures", options->run.pictures, "Format of the pictures of the tests (default: svg)")
      .one_of({"svg", "png"});
  command.flag("--resume", options->run.resume, "Continue an interrupted search in the same folder");
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.act([options] { calibrate(*options); });
}

// The following functions implement `talus point`.

namespace {

struct PointCommand {
  CaseOptions input;
  laboratory::PointOptions options;
  bool quiet = false, no_report = false;
};

void run_tests(PointCommand& command) {
  const input::LoadedCase loaded =
      input::read_case(command.input.file, command.input.parse_overrides(), input::CaseScope::whole_or_tests);
  if (command.options.folder.empty())
    command.options.folder = std::filesystem::path(command.input.file).stem().string() + "_point";
  const results::PointTests tests = laboratory::run_point_tests(loaded, command.options);
  if (!command.no_report) report::write_report(command.options.folder);
  if (command.quiet) return;
  print(stdout, fmt::format("{}Tables and pictures are in {}{}\n", laboratory::write_point_digest(tests),
                            (command.options.folder / "point").string(),
                            command.no_report ? ""
                                              : fmt::format("; open {} in a browser",
                                                            (command.options.folder / "report.html").string())));
}

}  // namespace

void add_point(CLI::App& app) {
  const Command command(app, "point", "Run the element tests of a case: one material point, no mesh");
  const auto options = std::make_shared<PointCommand>();
  options->input.add_to(command);
  command.take("-o,--output,--out", options->options.folder,
               "Folder for the results, which may be that of a run (default: the case's name with _point)");
  command.take("--test", options->options.names, "Run only the test of this name; repeatable").one_each();
  command.take("--pictures", options->options.pictures, "Format of the pictures (default: svg)").one_of({"svg", "png"});
  command.flag("--no-report", options->no_report, "Write no report.html (talus report writes it later)");
  command.flag("-q,--quiet", options->quiet, "Print errors only");
  command.act([options] { run_tests(*options); });
}

}  // namespace talus::app
