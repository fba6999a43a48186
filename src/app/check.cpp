#include <fmt/format.h>

#include <memory>

#include "analysis/end_state.hpp"
#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "model/read.hpp"

namespace talus::app {
namespace {

std::string count(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Two lines: what the soil is, and what is calculated.
std::string summarise(const model::Case& data) {
  double time = 0;
  for (const model::Stage& stage : data.stages) time += stage.duration;
  const std::string mesh = data.mesh.file.empty() ? fmt::format("elements of {:g} m", data.mesh.size)
                                                  : fmt::format("mesh '{}'", data.mesh.file);
  return fmt::format(
      "  {}D, {}, {} points per element; {}, {}, {}\n  {}: {}, together at most {:g} s{}\n", data.mesh.dimension, mesh,
      data.points_per_element, count(data.regions.size(), "region", "regions"),
      count(data.materials.size(), "material", "materials"),
      count(data.boundaries.size(), "boundary condition", "boundary conditions") +
          (data.hydraulics.empty()
               ? ""
               : ", " + count(data.hydraulics.size(), "hydraulic condition", "hydraulic conditions")),
      data.analysis == model::AnalysisKind::run ? "run" : "strength reduction",
      count(data.stages.size(), "stage", "stages"), time,
      data.study.vary.empty() ? "" : fmt::format("; a study varies {}", count(data.study.vary.size(), "key", "keys")));
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* command = app.add_subcommand("check", "Check a case file and report all of its faults");
  const auto options = std::make_shared<CaseOptions>();
  options->add_to(*command);
  command->callback([options] {
    const model::LoadedCase loaded =
        model::read_case(options->file, options->parse_overrides(), model::CaseScope::whole_or_tests);
    if (!loaded.data.initial.result.empty())
      model::check_against_result(loaded, analysis::EndState(loaded.data.initial).input());
    fmt::print("{}: no errors\n{}", options->file,
               loaded.is_whole ? summarise(loaded.data)
                               : fmt::format("  {} of {}, no slope\n",
                                             count(loaded.data.tests.size(), "element test", "element tests"),
                                             count(loaded.data.materials.size(), "material", "materials")));
  });
}

}  // namespace talus::app
