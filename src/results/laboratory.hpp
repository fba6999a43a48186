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
void describe(Visitor& v, PointTest& r);

struct PointPanel {
  std::string x, y;
  bool log_x = false;
};
void describe(Visitor& v, PointPanel& r);

/// Tests drawn in one picture.
struct PointGroup {
  std::string id, title, picture;
  std::vector<PointPanel> panels;
  std::vector<std::size_t> tests;
  std::vector<int> colour, dash;
};
void describe(Visitor& v, PointGroup& r);

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
void describe(Visitor& v, PointTests& r);

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
void describe(Visitor& v, CalibratedParameter& r);

/// A quantity with its unit of display.
struct ShownQuantity {
  std::string name, title, unit;
};
void describe(Visitor& v, ShownQuantity& r);

/// A measured curve and the calculated curves, in the units of its axes.
struct CalibratedCurve {
  std::string test;
  ShownQuantity x, y;
  std::vector<double> at, measured, before, fitted;
  std::vector<Point> line, line_before;
  double deviation = 0, weight = 1;
  double rms = 0, rms_before = 0, mean = 0, largest = 0, largest_at = 0, missing = 0;
};
void describe(Visitor& v, CalibratedCurve& r);

/// One of the least-squares searches, each from its own start.
struct CalibrationSearch {
  std::vector<double> from, to;
  double misfit = 0, misfit_before = 0;
  bool converged = false;
  int iterations = 0;
  std::string message;
};
void describe(Visitor& v, CalibrationSearch& r);

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
void describe(Visitor& v, Calibration& r);

}  // namespace talus::results
