// SPDX-License-Identifier: MIT
// `talus check CASE`: all faults of a case file, or a summary of its calculation.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/partial_factors.hpp"
#include "input/read.hpp"
#include "input/sketch.hpp"
#include "output/plots/gnuplot.hpp"
#include "run/case_picture.hpp"
#include "run/check_case.hpp"
#include "run/forecast/forecast.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/run_case.hpp"
#include "study/study.hpp"

namespace talus::app {
namespace {

std::string count(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Formats a length in the unit of histories and plots of the case.
std::string show_length(const input::Case& data, double metres) {
  const std::string& unit = data.output.length_unit;
  return fmt::format("{:.4g} {}", metres / units::get_si_factor(unit), unit);
}

/// Describes mesh, soils and hydraulic conditions of a case.
std::string describe_soil(const input::Case& data) {
  const bool has_points = input::uses(data, input::Method::mpm);
  std::string mesh;
  if (!data.mesh.file.empty())
    mesh = fmt::format(", mesh '{}'", data.mesh.file);
  else if (has_points)
    mesh = ", elements of " + show_length(data, data.mesh.size);
  if (has_points) mesh += fmt::format(", {} points per element", data.points_per_element);
  const std::string hydraulics =
      data.hydraulics.empty() ? ""
                              : ", " + count(data.hydraulics.size(), "hydraulic condition", "hydraulic conditions");
  return fmt::format("  {}D{}; {}, {}, {}{}\n", data.mesh.dimension, mesh,
                     count(data.regions.size(), "region", "regions"),
                     count(data.materials.size(), "material", "materials"),
                     count(data.boundaries.size(), "boundary condition", "boundary conditions"), hydraulics);
}

std::string describe_slices(const input::LimitEquilibrium& lem) {
  std::string methods;
  for (const input::SliceMethod method : lem.methods)
    methods += (methods.empty() ? "" : ", ") + std::string(get_title(method));
  std::string surfaces;
  if (lem.search == input::SurfaceSearch::entry_exit) surfaces = "circles between entries and exits";
  if (lem.search == input::SurfaceSearch::grid) surfaces = "circles about a grid of centres";
  if (!surfaces.empty() && lem.noncircular && !lem.tangent) surfaces += ", then polylines";
  if (lem.search == input::SurfaceSearch::block)
    surfaces = lem.block.along.empty() ? "polylines through windows" : "polylines along '" + lem.block.along + "'";
  if (!lem.surfaces.empty())
    surfaces += (surfaces.empty() ? "" : ", and ") + count(lem.surfaces.size(), "given surface", "given surfaces");
  return fmt::format("  limit equilibrium: {}; {}\n", methods, surfaces);
}

std::string describe_elements(const input::Case& data) {
  const double size = data.fem.size.value_or(data.mesh.size);
  const char* flow = data.fem.flow == input::FlowRule::as_given     ? "ψ as given"
                     : data.fem.flow == input::FlowRule::associated ? "ψ = φ"
                                                                    : "ψ as given and ψ = φ";
  std::string sizes;
  if (data.mesh.file.empty()) sizes = " with elements of " + show_length(data, size);
  if (data.mesh.file.empty() && data.fem.adapt)
    sizes = fmt::format(" with elements of {}, refined where the soil shears", show_length(data, 2 * size));
  else if (data.mesh.file.empty() && data.fem.meshes > 1)
    sizes += " and of " + show_length(data, 2 * size);
  const std::string davis =
      data.fem.davis == input::DavisRule::none || data.fem.flow == input::FlowRule::associated
          ? ""
          : fmt::format(", with the strength of Davis {:c}", "ABC"[static_cast<int>(data.fem.davis) - 1]);
  const char* softening = data.fem.softening == input::FemSoftening::progressive ? ", with progressive failure" : "";
  return fmt::format("  FEM: strength reduction{}, {}{}{}\n", sizes, flow, davis, softening);
}

std::string describe_bounds(const input::ProvenBounds& bounds) {
  return fmt::format("  limit analysis: to {:g} % of the factor, with at most {} triangles\n", 100 * bounds.gap,
                     bounds.triangles);
}

std::string describe_points(const input::Case& data) {
  double time = 0;
  for (const input::Stage& stage : data.stages) time += stage.duration;
  return fmt::format("  {}{}: {}, together at most {:g} s\n", data.methods.size() > 1 ? "MPM, " : "",
                     data.analysis == input::AnalysisKind::run ? "run" : "strength reduction",
                     count(data.stages.size(), "stage", "stages"), time);
}

std::string describe_flow(const input::SeepageAnalysis& seepage) {
  return fmt::format("  seepage: {}\n",
                     seepage.times.empty() ? "steady flow" : "flow at " + count(seepage.times.size(), "time", "times"));
}

/// Returns one line on the soil and one on each method of the case, with its forecast.
std::string summarise(const input::Case& data) {
  std::string text = describe_soil(data);
  for (const run::MethodForecast& needs : run::forecast(data, true)) {
    if (needs.method == input::Method::lem) text += describe_slices(data.lem);
    if (needs.method == input::Method::fem) text += describe_elements(data);
    if (needs.method == input::Method::bounds) text += describe_bounds(data.bounds);
    if (needs.method == input::Method::mpm) text += describe_points(data);
    if (needs.method == input::Method::seepage) text += describe_flow(data.seepage);
    if (const std::string words = run::describe(needs); !words.empty()) text += fmt::format("    {}\n", words);
  }
  if (const input::PartialFactorValues factors = input::find_partial_factors(data.partial_factors); factors.is_active())
    text += fmt::format("  with partial factors {}\n", factors.set);
  return text;
}

struct CheckOptions : CaseOptions {
  std::filesystem::path picture;

  /// Throws Error (wrong_input) for a picture in another format.
  void check_picture() const {
    if (!picture.empty() && picture.extension() != ".svg" && picture.extension() != ".png")
      fail_input("'{}' cannot be drawn: the name of the picture of a case ends with .svg or .png", picture.string());
  }
};

/// Checks a case and prints its warnings and its summary. `warnings` receives the warnings. Throws InputError with all
/// faults of the file, and Error for faults that its methods find.
void check_case(const CheckOptions& options, const std::vector<input::Override>& overrides,
                std::vector<run::CaseMessage>& warnings) {
  const input::LoadedCase loaded = input::read_case(options.file, overrides, input::CaseScope::whole_or_tests);
  for (const Diagnostic& warning : loaded.warnings) warnings.push_back({false, warning});
  if (!loaded.data.initial.result.empty())
    input::check_against_result(loaded, run::EndState(loaded.data.initial).input());
  if (loaded.is_whole) {
    run::check_ready_mesh(loaded);
    run::refuse_above_memory(loaded);
    run::check_methods(loaded.data);
  }
  const std::vector<std::string> lines = run::list_warnings(loaded);
  for (const std::string& line : lines) print(stderr, line + "\n");
  // Warnings of the ground follow those of the file, and have no place in it.
  constexpr std::string_view word = "warning: ";
  for (std::size_t i = loaded.warnings.size(); i < lines.size(); ++i)
    warnings.push_back({false, {"", 0, 0, lines[i].starts_with(word) ? lines[i].substr(word.size()) : lines[i]}});
  print(stdout,
        fmt::format("{}: no errors{}\n{}", options.file,
                    lines.empty() ? "" : ", " + count(lines.size(), "warning", "warnings"),
                    loaded.is_whole ? summarise(loaded.data) + study::forecast_study(loaded, overrides)
                                    : fmt::format("  {} of {}, no slope\n",
                                                  count(loaded.data.tests.size(), "element test", "element tests"),
                                                  count(loaded.data.materials.size(), "material", "materials"))));
}

/// Draws the case with its messages and prints the name of the picture. A fault of the case suppresses
/// its warnings; those of the keys without faults are then added. Throws Error (wrong_input) for a case without a plane
/// section, and as write_atomically() and draw_png().
void draw_case(const CheckOptions& options, const std::vector<input::Override>& overrides,
               std::vector<run::CaseMessage> messages) {
  const input::Sketch sketch = input::read_sketch(options.file, overrides, input::CaseScope::whole_or_tests);
  if (std::all_of(messages.begin(), messages.end(), [](const run::CaseMessage& m) { return m.is_error; }))
    for (const Diagnostic& warning : input::read_warnings(options.file, overrides, input::CaseScope::whole_or_tests))
      messages.push_back({false, warning});
  output::CasePicture picture = run::make_case_picture(sketch, messages);
  if (picture.title.empty()) picture.title = options.file;
  const auto files = FileList::find(options.picture);
  const std::string svg = output::write_case_picture(picture);
  if (options.picture.extension() == ".png")
    output::draw_png(options.picture, svg);
  else
    write_atomically(options.picture, svg);
  print(stdout, fmt::format("{}\n", options.picture.string()));
}

/// Draws a case with faults. A fault of the picture is printed, and those of the case remain the error of the command.
void draw_faulty_case(const CheckOptions& options, const std::vector<input::Override>& overrides,
                      const std::vector<run::CaseMessage>& messages) {
  try {
    draw_case(options, overrides, messages);
  } catch (const Error& error) {
    print(stderr, fmt::format("talus: warning: no picture: {}\n", error.what()));
  }
}

}  // namespace

void add_check(CLI::App& app) {
  const Command command(app, "check", "Check a case file: list all of its faults, or what it would calculate");
  const auto options = std::make_shared<CheckOptions>();
  options->add_to(command);
  command
      .take("--picture", options->picture,
            "Draw the section with soils, water, loads, supports, mesh and search, and every message at its place; the "
            "ending, .svg or .png, sets the format")
      .shown_as("FILE");
  command.act([options] {
    options->check_picture();
    const std::vector<input::Override> overrides = options->parse_overrides();
    std::vector<run::CaseMessage> messages;
    try {
      check_case(*options, overrides, messages);
    } catch (const InputError& error) {
      for (const Diagnostic& fault : error.diagnostics()) messages.push_back({true, fault});
      if (!options->picture.empty()) draw_faulty_case(*options, overrides, messages);
      throw;
    } catch (const Error& error) {
      messages.push_back({true, {"", 0, 0, error.what()}});
      if (!options->picture.empty()) draw_faulty_case(*options, overrides, messages);
      throw;
    }
    if (!options->picture.empty()) draw_case(*options, overrides, messages);
  });
}

}  // namespace talus::app
