// SPDX-License-Identifier: MIT
#pragma once
// Results of element tests and of calibration: point/point.json and calibration/calibration.json.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "results/comparison.hpp"
#include "results/run.hpp"

namespace talus::results {

/// One element test.
struct PointTest {
  std::string name, material, kind, path, set, file;
  std::size_t steps = 0;
  std::vector<std::size_t> turns;  ///< rows at which the loading path changes direction
  std::string stopped;             ///< why the test ended early; empty if it did not
  double peak_q = 0;               ///< [Pa]
  double peak_q_strain = 0;
  std::map<std::string, double> end;  ///< every quantity of the last row [SI]
};
void describe(auto& v, As<PointTest> auto& r) {
  v.key("name", r.name, {"", "name of the test"});
  v.key("material", r.material, {"", "material"});
  v.key("kind", r.kind, {"", "kind"});
  v.key("path", r.path, {"", "path in words"});
  v.key("set", r.set, {"", "what the test sets"});
  v.key("file", r.file, {"", "file of its rows"});
  v.key("steps", r.steps, {"", "steps"});
  v.key("turns", r.turns, {"", "rows where the path turns"});
  v.key("stopped", r.stopped, {"", "why it ended early"});
  v.key("peak_q", r.peak_q, {"Pa", "largest deviatoric stress"});
  v.key("peak_q_strain", r.peak_q_strain, {"", "strain at the largest deviatoric stress"});
  v.key("end", r.end, {"", "quantities at the end"});
}

struct PointPanel {
  std::string x, y;
  bool log_x = false;
};
void describe(auto& v, As<PointPanel> auto& r) {
  v.key("x", r.x, {"", "quantity along x"});
  v.key("y", r.y, {"", "quantity along y"});
  v.key("log_x", r.log_x, {"", "whether x is logarithmic"});
}

/// Tests drawn in one picture.
struct PointGroup {
  std::string id, title, picture;
  std::vector<PointPanel> panels;
  std::vector<std::size_t> tests;
  std::vector<int> colour, dash;
};
void describe(auto& v, As<PointGroup> auto& r) {
  v.key("id", r.id, {"", "group"});
  v.key("title", r.title, {"", "title"});
  v.key("picture", r.picture, {"", "file of the picture"});
  v.key("panels", r.panels, {"", "diagrams"});
  v.key("tests", r.tests, {"", "numbers of its tests"});
  v.key("colour", r.colour, {"", "colour of each"});
  v.key("dash", r.dash, {"", "dashes of each"});
}

/// Element tests of a case.
struct PointTests {
  int format = result_format;
  std::string title;
  Project project;
  JsonTree input;
  Provenance provenance;
  DisplayUnits units;
  std::vector<PointTest> tests;
  std::vector<PointGroup> groups;
  std::map<std::string, double> point_results;  ///< results by their names in [[compare]] [SI]
  std::vector<std::string> warnings;
  std::vector<Comparison> comparisons;
  Timing timing;
};
void describe(auto& v, As<PointTests> auto& r) {
  v.key("format", r.format, {"", "version of this file"});
  v.key("title", r.title, {"", "title of the case"});
  v.key("project", r.project, {"", "title block"});
  v.key("input", r.input, {"", "every key of the case"});
  v.key("provenance", r.provenance, {"", "program, machine and input"});
  v.key("units", r.units, {"", "units of display"});
  v.key("tests", r.tests, {"", "element tests"});
  v.key("groups", r.groups, {"", "tests that are drawn together"});
  v.key("point_results", r.point_results, {"", "results that the case compares"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("comparisons", r.comparisons, {"", "results beside what the case expects"});
  v.key("timing", r.timing, {"", "seconds"});
}

enum class AtLimit { no, low, high };
template <>
inline constexpr auto words<AtLimit> = std::array{"no", "low", "high"};

/// A fitted soil parameter; numbers are in `unit`.
struct CalibratedParameter {
  std::string key, unit;
  double start = 0, value = 0;
  std::string text;  ///< value as `--set` takes it
  double low = 0, high = 0;
  std::optional<double> error;  ///< standard error
  AtLimit limit = AtLimit::no;
};
void describe(auto& v, As<CalibratedParameter> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("start", r.start, {"", "start"});
  v.key("value", r.value, {"", "fitted value"});
  v.key("text", r.text, {"", "as --set takes it"});
  v.key("low", r.low, {"", "lower limit"});
  v.key("high", r.high, {"", "upper limit"});
  v.key("error", r.error, {"", "standard error"});
  v.key("limit", r.limit, {"", "limit that it lies at"});
}

/// A quantity with its unit of display.
struct ShownQuantity {
  std::string name, title, unit;
};
void describe(auto& v, As<ShownQuantity> auto& r) {
  v.key("name", r.name, {"", "quantity"});
  v.key("title", r.title, {"", "title"});
  v.key("unit", r.unit, {"", "unit"});
}

/// A measured curve and the calculated curves, in the units of its axes.
struct CalibratedCurve {
  std::string test;
  ShownQuantity x, y;
  std::vector<double> at, measured, before, fitted;
  std::vector<Point> line, line_before;
  double deviation = 0, weight = 1;
  double rms = 0, rms_before = 0, mean = 0, largest = 0, largest_at = 0, missing = 0;
};
void describe(auto& v, As<CalibratedCurve> auto& r) {
  v.key("test", r.test, {"", "test"});
  v.key("x", r.x, {"", "quantity along x"});
  v.key("y", r.y, {"", "quantity along y"});
  v.key("at", r.at, {"", "measured along x"});
  v.key("measured", r.measured, {"", "measured along y"});
  v.key("before", r.before, {"", "calculated with the start"});
  v.key("fitted", r.fitted, {"", "calculated with the fitted values"});
  v.key("line", r.line, {"", "calculated curve"});
  v.key("line_before", r.line_before, {"", "calculated curve with the start"});
  v.key("deviation", r.deviation, {"", "deviation of a measured value"});
  v.key("weight", r.weight, {"", "weight"});
  v.key("rms", r.rms, {"", "root mean square of the differences"});
  v.key("rms_before", r.rms_before, {"", "the same with the start"});
  v.key("mean", r.mean, {"", "mean difference"});
  v.key("largest", r.largest, {"", "largest difference"});
  v.key("largest_at", r.largest_at, {"", "where it is"});
  v.key("missing", r.missing, {"", "share of the abscissae that the test does not reach"});
}

/// One of the least-squares searches, each from its own start.
struct CalibrationSearch {
  std::vector<double> from, to;
  double misfit = 0, misfit_before = 0;
  bool converged = false;
  int iterations = 0;
  std::string message;
};
void describe(auto& v, As<CalibrationSearch> auto& r) {
  v.key("from", r.from, {"", "start"});
  v.key("to", r.to, {"", "end"});
  v.key("misfit", r.misfit, {"", "half the sum of the squares at the end"});
  v.key("misfit_before", r.misfit_before, {"", "half the sum of the squares at the start"});
  v.key("converged", r.converged, {"", "whether it converged"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("message", r.message, {"", "message of the solver"});
}

struct Calibration {
  int format = result_format;
  std::string title;
  std::uint64_t seed = 0;
  double wall = 0;  ///< [s]
  std::vector<CalibratedParameter> parameters;
  std::vector<CalibratedCurve> curves;
  std::vector<std::vector<std::optional<double>>> correlation;
  std::vector<CalibrationSearch> starts;
  std::size_t best = 0, values = 0;
  double scatter = 0;
  long evaluations = 0, tests = 0;
  std::vector<std::string> findings;
};
void describe(auto& v, As<Calibration> auto& r) {
  v.key("format", r.format, {"", "version of this file"});
  v.key("title", r.title, {"", "title of the case"});
  v.key("seed", r.seed, {"", "seed of the starts"});
  v.key("wall", r.wall, {"s", "wall time"});
  v.key("parameters", r.parameters, {"", "fitted parameters"});
  v.key("curves", r.curves, {"", "curves"});
  v.key("correlation", r.correlation, {"", "correlation of the parameters"});
  v.key("starts", r.starts, {"", "searches"});
  v.key("best", r.best, {"", "number of the best search"});
  v.key("values", r.values, {"", "measured values"});
  v.key("scatter", r.scatter, {"", "scatter of the fit"});
  v.key("evaluations", r.evaluations, {"", "sets of parameters that were tried"});
  v.key("tests", r.tests, {"", "tests that were run"});
  v.key("findings", r.findings, {"", "what to distrust"});
}

}  // namespace talus::results
