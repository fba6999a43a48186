// SPDX-License-Identifier: MIT
// `talus point CASE`: element tests of the soils of a case, without a mesh.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "base/encoding.hpp"
#include "input/read.hpp"
#include "laboratory/run_point_tests.hpp"
#include "report/report.hpp"

namespace talus::app {
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
