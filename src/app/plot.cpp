// SPDX-License-Identifier: MIT
// `talus plot`: pictures of the results of a run, or of the soil-water curves of a case.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/command_line.hpp"
#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "input/read.hpp"
#include "output/files/frames_reader.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "output/plots/section_plot.hpp"
#include "output/plots/water_plot.hpp"
#include "results/json.hpp"
#include "results/run.hpp"

namespace talus::app {

namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  fs::path folder;
  std::string field;
  std::string frame = "last";
  std::optional<double> time;
  std::string format;
  fs::path out;
  bool logarithmic = false;
  std::vector<std::string> sets;  ///< changes to a case, key=value

  /// Returns the file of a picture; a `large` one is PNG by default.
  fs::path choose_picture(const std::string& stem, bool large) const {
    if (!out.empty()) return out;
    return folder / (stem + "." + (!format.empty() ? format : large ? "png" : "svg"));
  }
};

// Pictures of the fields of a run and of soil-water curves.

/// With more points an SVG picture has tens of megabytes, and PNG is the default.
constexpr std::size_t most_points_in_svg = 20000;

int choose_frame(const output::ResultsReader& reader, const PlotOptions& options) {
  if (options.time) return reader.find_nearest(*options.time);
  if (options.frame == "last") return reader.size() - 1;
  int number = 0;
  const char* end = options.frame.data() + options.frame.size();
  const auto [stop, failure] = std::from_chars(options.frame.data(), end, number);
  if (failure != std::errc() || stop != end) fail_input("--frame '{}' is neither a number nor 'last'", options.frame);
  return number;
}

/// Names of the components of a field; the default one comes first.
std::vector<std::string> list_components(int components) {
  if (components == 1) return {};
  if (components == 2) return {"magnitude", "x", "y"};
  if (components == 3) return {"magnitude", "x", "y", "z"};
  if (components == 4) return {"mean", "xx", "yy", "zz", "xy"};
  if (components == 6) return {"mean", "xx", "yy", "zz", "xy", "yz", "xz"};
  std::vector<std::string> names{"magnitude"};
  for (int c = 0; c < components; ++c) names.push_back(std::to_string(c));
  return names;
}

/// Returns one number per point of `field`: a component, the length of a vector, or a third of the trace of a tensor.
std::vector<double> reduce(const output::Field& field, const std::string& component) {
  const std::vector<std::string> names = list_components(field.components);
  const auto n = static_cast<std::size_t>(field.components), count = field.values.size() / n;
  if (names.empty() && component.empty()) return field.values;
  const std::string wanted = component.empty() ? names[0] : component;
  const auto found = std::ranges::find(names, wanted);
  if (found == names.end())
    fail_input("'{}' has no component '{}'{}", field.name, wanted,
               names.empty() ? "" : fmt::format("; it has {}", fmt::join(names, ", ")));
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* v = &field.values[i * n];
    double square = 0;
    for (std::size_t c = 0; c < n; ++c) square += v[c] * v[c];
    values[i] = wanted == "magnitude" ? std::sqrt(square)
                : wanted == "mean"    ? (v[0] + v[1] + v[2]) / 3
                                      : v[static_cast<std::size_t>(found - names.begin()) - 1];
  }
  return values;
}

/// Returns the display unit of a field.
std::string choose_unit(const output::Field& field, const results::DisplayUnits& units) {
  if (field.unit == "Pa") return units.stress;
  if (field.unit == "m") return units.displacement;
  return field.unit;
}

/// Draws the requested field of a frame in the units of `run`, and prints the name of the picture. Throws Error
/// (wrong_input) if there is no such field or frame, and what output::ResultsReader and output::draw throw.
void draw_field(const PlotOptions& options, const results::RunResult& run) {
  const output::ResultsReader reader(options.folder);
  std::string name = options.field, component;
  const auto& names = reader.field_names();
  if (name.empty())
    name =
        std::ranges::find(names, "deviatoric_strain") != names.end() || names.empty() ? "deviatoric_strain" : names[0];
  if (std::ranges::find(names, name) == names.end()) {
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos) component = name.substr(dot + 1), name.resize(dot);
    if (std::ranges::find(names, name) == names.end())
      fail_input("there is no field '{}' in '{}'; the fields are {}", name, options.folder.string(),
                 fmt::join(names, ", "));
  }
  const int index = choose_frame(reader, options);
  const output::Frame frame = reader.read(index);
  const output::Field* field = output::find(frame.point_fields, name);
  if (field == nullptr) fail_input("frame {} has no field '{}'", index, name);

  output::FieldPlot plot;
  const std::string shown =
      component.empty() && field->components > 1 ? list_components(field->components)[0] : component;
  plot.title = output::to_words(name) + (shown.empty() ? "" : ", " + shown);
  plot.subtitle = fmt::format("t = {:.4g} s, {}", frame.time, frame.stage);
  plot.positions = frame.positions;
  plot.values = reduce(*field, component);
  plot.unit = choose_unit(*field, run.units);
  plot.length_unit = run.units.length;
  plot.units_per_metre = 1 / units::get_si_factor(run.units.length);
  if (plot.unit != field->unit)
    for (double& v : plot.values) v /= units::get_si_factor(plot.unit);
  if (shown == "magnitude") plot.signed_values = false;
  plot.outlines = run.outlines;
  const std::string stem = fmt::format("{}{}{}_{:04d}", name, component.empty() ? "" : "_", component, index);
  const fs::path picture = options.choose_picture(stem, plot.values.size() > most_points_in_svg);
  output::draw(plot, picture);
  print(stdout, fmt::format("{}\n", picture.string()));
}

/// Draws the soil-water curves of every soil with pore water into `picture`, and writes their numbers beside it as
/// .csv. By default the picture is the name of the case with _soil_water, in the current folder, in `format` ("svg",
/// "png"). Prints both names. Throws Error (wrong_input) for a case without pore water.
void plot_soil_water(const CaseOptions& input, const std::filesystem::path& picture, const std::string& format) {
  const input::LoadedCase loaded = input::read_case(input.file, input.parse_overrides());
  const output::WaterPlot plot{loaded.data.title, output::sample_water_curves(loaded.data)};
  if (plot.soils.empty())
    fail_input(
        "there is nothing to draw in '{}': no material of it has pore water, a table [materials.NAME.water]; for the "
        "results of a run give their folder",
        input.file);
  const std::string name = std::filesystem::path(input.file).stem().string() + "_soil_water";
  const std::filesystem::path drawn =
      picture.empty() ? std::filesystem::path(name + "." + (format.empty() ? "svg" : format)) : picture;
  const std::filesystem::path table = std::filesystem::path(drawn).replace_extension(".csv");
  output::draw(plot, drawn);
  write_atomically(table, output::make_water_table(plot.soils));
  print(stdout, fmt::format("{}\n{}\n", drawn.string(), table.string()));
}

// Curves and sections of a run.

void draw(const PlotOptions& options, const auto& plot, const std::string& stem) {
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
    fail_input(
        "'{}' is a case, which has no results yet; --field, --frame, --time and --log need the folder of a run's "
        "results",
        options.folder.string());
  plot_soil_water({options.folder.string(), options.sets}, options.out, options.format);
}

void plot_folder(const PlotOptions& options) {
  if (!fs::is_directory(options.folder))
    fail_input("there is no folder and no case file '{}'", options.folder.string());
  if (!options.sets.empty()) fail_input("--set changes a case; results stay as they are");
  const ResultsLock lock(options.folder);
  const auto read = results::read_file<results::RunResult>(options.folder / "summary.json");
  const results::RunResult run = read.value_or(results::RunResult{});  // the folder of a trial has no summary
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
    fail_input(run.slices || run.elements
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
