// SPDX-License-Identifier: MIT
// The fields of a run on its material points, as `talus plot` draws them.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/plot_results.hpp"
#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "output/files/frames_reader.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Above this an SVG picture has tens of megabytes, and PNG is the default.
constexpr std::size_t most_points_in_svg = 20000;

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

int choose_frame(const output::ResultsReader& reader, const PlotOptions& options) {
  if (options.time) return reader.find_nearest(*options.time);
  if (options.frame == "last") return reader.size() - 1;
  int number = 0;
  const char* end = options.frame.data() + options.frame.size();
  const auto [stop, failure] = std::from_chars(options.frame.data(), end, number);
  if (failure != std::errc() || stop != end)
    fail(fmt::format("--frame '{}' is neither a number nor 'last'", options.frame));
  return number;
}

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Names of the components of a field, the shown one first when none is asked for.
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

/// One number per point of `field`: a component, the length of a vector, or a third of a tensor's trace.
std::vector<double> reduce(const output::Field& field, const std::string& component) {
  const std::vector<std::string> names = list_components(field.components);
  const auto n = static_cast<std::size_t>(field.components), count = field.values.size() / n;
  if (names.empty() && component.empty()) return field.values;
  const std::string wanted = component.empty() ? names[0] : component;
  const auto found = std::ranges::find(names, wanted);
  if (found == names.end())
    fail(fmt::format("'{}' has no component '{}'{}", field.name, wanted,
                     names.empty() ? "" : fmt::format("; it has {}", join(names))));
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

/// The unit in which a stored unit is shown.
std::string choose_unit(const output::Field& field, const results::DisplayUnits& units) {
  if (field.unit == "Pa") return units.stress;
  if (field.unit == "m") return units.displacement;
  return field.unit;
}

}  // namespace

fs::path PlotOptions::choose_picture(const std::string& stem, bool large) const {
  if (!out.empty()) return out;
  return folder / (stem + "." + (!format.empty() ? format : large ? "png" : "svg"));
}

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
      fail(
          fmt::format("there is no field '{}' in '{}'; the fields are {}", name, options.folder.string(), join(names)));
  }
  const int index = choose_frame(reader, options);
  const output::Frame frame = reader.read(index);
  const output::Field* field = output::find(frame.point_fields, name);
  if (field == nullptr) fail(fmt::format("frame {} has no field '{}'", index, name));

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

}  // namespace talus::app
