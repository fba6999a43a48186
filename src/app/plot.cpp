// SPDX-License-Identifier: MIT
// `talus plot`: pictures of a run's results, or of the soil-water curves of a case.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/plot_results.hpp"
#include "app/plot_soil_water.hpp"
#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/units.hpp"
#include "output/files/frames_reader.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/section_plot.hpp"
#include "results/json.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

template <class Plot>
void draw(const PlotOptions& options, const Plot& plot, const std::string& stem) {
  const fs::path picture = options.choose_picture(stem, false);
  output::draw(plot, picture);
  print(stdout, fmt::format("{}\n", picture.string()));
}

output::CurvePlot describe_curve(const results::RunResult& run, const results::DisplacementCurve& curve) {
  output::CurvePlot plot;
  plot.title = run.title;
  plot.displacement_unit = run.units.displacement;
  plot.units_per_metre = 1 / units::get_si_factor(run.units.displacement);
  for (const results::Trial& t : curve.points) {
    plot.factors.push_back(t.factor);
    plot.displacements.push_back(t.displacement);
  }
  if (curve.bilinear) {
    plot.intersection = curve.bilinear->factor;
    plot.first = curve.bilinear->first;
    plot.second = curve.bilinear->second;
  }
  for (const results::Criterion& c : curve.criteria)
    if (c.factor) plot.criteria.push_back({to_word(c.kind), *c.factor, c.lower, c.upper});
  return plot;
}

output::SectionPlot describe_section(const results::RunResult& run) {
  output::SectionPlot plot{run.title, run.outlines, run.methods->surfaces, run.units.length, std::nullopt};
  if (run.water_states && !run.water_states->empty()) plot.water = run.water_states->back();
  return plot;
}

void plot_case(const PlotOptions& options) {
  if (!options.field.empty() || options.time || options.frame != "last" || options.logarithmic)
    fail(
        fmt::format("'{}' is a case, which has no results yet; --field, --frame, --time and --log need the folder of a "
                    "run's results",
                    options.folder.string()));
  plot_soil_water({options.folder.string(), options.sets}, options.out, options.format);
}

void plot_folder(const PlotOptions& options) {
  if (!fs::is_directory(options.folder))
    fail(fmt::format("there is no folder and no case file '{}'", options.folder.string()));
  if (!options.sets.empty()) fail("--set changes a case; results stay as they are");
  const ResultsLock lock(options.folder);
  const auto read = results::read_file<results::RunResult>(options.folder / "summary.json");
  const results::RunResult run = read.value_or(results::RunResult{});  // a folder of a trial has none
  const bool wants_field = !options.field.empty();
  if (run.curve && !wants_field) {
    output::CurvePlot plot = describe_curve(run, *run.curve);
    plot.log_displacement = options.logarithmic;
    draw(options, plot, "curve");
    if (!options.out.empty()) return;
  }
  const bool has_frames = output::holds_frames(options.folder);
  if (wants_field || has_frames)
    draw_field(options, run);
  else if (run.methods && !run.methods->surfaces.empty() && !run.curve)
    draw(options, describe_section(run), "section");
  else if (!run.curve)
    fail(run.slices || run.elements
             ? fmt::format("there is nothing to draw in '{}': the methods have found no slip surface",
                           options.folder.string())
             : fmt::format("there is nothing to draw in '{}': neither frames nor a summary.json with a curve",
                           options.folder.string()));
}

}  // namespace

void add_plot(CLI::App& app) {
  const Command command(app, "plot",
                        "Draw curve, fields or slip surfaces of results, or the soil-water curves of a case");
  const auto options = std::make_shared<PlotOptions>();
  command.take("DIR", options->folder, "Folder of the results; or a case file, for its soil-water curves").required();
  command.take("--field", options->field, "Field to draw; a component as NAME.xx, NAME.x, NAME.magnitude or NAME.mean");
  const Argument frame = command.take("--frame", options->frame, "Number of the frame, from 0, or 'last' (default)");
  command.take("--time", options->time, "Draw the frame nearest to this time [s]").excludes(frame);
  command.take("--format", options->format, "svg (default) or png (default above 20,000 points)")
      .one_of({"svg", "png"});
  command.take("--out", options->out, "File of the picture; its ending, .svg or .png, sets the format");
  command.flag("--log", options->logarithmic, "Draw the displacements of the curve on a logarithmic axis");
  command.take("--set", options->sets, "Change a key of the case, as in --set materials.sand.water.lambda=0.3")
      .shown_as("KEY=VALUE")
      .one_each();
  command.act([options] { fs::is_regular_file(options->folder) ? plot_case(*options) : plot_folder(*options); });
}

}  // namespace talus::app
