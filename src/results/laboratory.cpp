// SPDX-License-Identifier: MIT
#include "results/laboratory.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, PointTest& r) {
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

void describe(Visitor& v, PointPanel& r) {
  v.key("x", r.x, {"", "quantity along x"});
  v.key("y", r.y, {"", "quantity along y"});
  v.key("log_x", r.log_x, {"", "whether x is logarithmic"});
}

void describe(Visitor& v, PointGroup& r) {
  v.key("id", r.id, {"", "group"});
  v.key("title", r.title, {"", "title"});
  v.key("picture", r.picture, {"", "file of the picture"});
  v.key("panels", r.panels, {"", "diagrams"});
  v.key("tests", r.tests, {"", "numbers of its tests"});
  v.key("colour", r.colour, {"", "colour of each"});
  v.key("dash", r.dash, {"", "dashes of each"});
}

void describe(Visitor& v, PointTests& r) {
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

void describe(Visitor& v, CalibratedParameter& r) {
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

void describe(Visitor& v, ShownQuantity& r) {
  v.key("name", r.name, {"", "quantity"});
  v.key("title", r.title, {"", "title"});
  v.key("unit", r.unit, {"", "unit"});
}

void describe(Visitor& v, CalibratedCurve& r) {
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

void describe(Visitor& v, CalibrationSearch& r) {
  v.key("from", r.from, {"", "start"});
  v.key("to", r.to, {"", "end"});
  v.key("misfit", r.misfit, {"", "half the sum of the squares at the end"});
  v.key("misfit_before", r.misfit_before, {"", "half the sum of the squares at the start"});
  v.key("converged", r.converged, {"", "whether it converged"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("message", r.message, {"", "message of the solver"});
}

void describe(Visitor& v, Calibration& r) {
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
