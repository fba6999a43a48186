// SPDX-License-Identifier: MIT
#pragma once
// Residuals between the element tests of a case, or the monitors of its stages of construction, and measurements, as a
// function of its parameters.

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "laboratory/evaluation_store.hpp"
#include "laboratory/point_results.hpp"
#include "laboratory/point_test.hpp"

namespace talus::laboratory {

/// Returns the leg of the test to which each point belongs, since loading and unloading legs cross the same abscissa.
/// Points are in the order of the measurement, so only the turning points are unknown; the division has the least
/// distance in the wrong direction. All zero for a test of one leg.
std::vector<std::size_t> find_legs(const input::PointTest& test, const std::vector<std::array<double, 2>>& points);

/// Ordinate of the curve at an abscissa.
struct Reading {
  double y = 0;
  double missing = 0;  ///< distance of the abscissa beyond the range of the leg, whose nearest end gives `y`
};

/// Reads the curve at the first place on `leg` with the abscissa x.
Reading read_curve(const PointCurve& curve, std::size_t leg, const std::string& x_name, const std::string& y_name,
                   double x);

/// Results of one set of parameters. Curves are those of the tests, then those of the monitors.
struct Comparison {
  std::vector<double> residuals;            ///< of the fitted curves: w (y_model - y)/σ
  std::vector<std::vector<double>> values;  ///< of every curve: y_model at the measured abscissae [SI]
  std::vector<double> missing;              ///< of every curve: mean fraction of its abscissae that is not reached [-]
  std::vector<std::vector<results::Point>> lines;  ///< of every curve, thinned; only if requested [SI]
};

class CalibrationModel {
 public:
  /// `data` must have a calibration and outlive the model, as must `store`, which receives the evaluations and replaces
  /// those that it has; nullptr: none is stored.
  explicit CalibrationModel(const input::Case& data, EvaluationStore* store = nullptr);

  std::size_t count_parameters() const { return calibration_.parameters.size(); }
  /// Number of measured values that are fitted, each with a residual.
  std::size_t count_values() const { return value_count_; }

  /// Value of parameter `i` at the place u of its range, 0 … 1; and the inverse.
  double find_value(std::size_t i, double u) const;
  std::vector<double> find_values(const std::vector<double>& places) const;
  double find_place(std::size_t i, double value) const;
  /// d value/d u.
  double find_slope(std::size_t i, double u) const;

  /// Step of differences, over the range of a parameter.
  double difference_step() const;
  /// Relative change of the misfit below which a search ends.
  double search_tolerance() const;

  /// Runs the tests and the stages with the parameters at `places`. Returns nullopt if they are invalid or a test
  /// cannot be run, with the reason in `why`. A stored evaluation has residuals only. Thread-safe.
  std::optional<Comparison> compare(const std::vector<double>& places, std::string* why = nullptr,
                                    bool with_lines = false) const;
  /// Number of tests and sequences of stages run so far, with those of stored evaluations.
  long count_runs() const { return runs_; }

 private:
  input::Material make_soil(std::size_t test, const std::vector<double>& places) const;
  /// Both return why the parameters are refused; empty if they are not.
  std::string compare_tests(const std::vector<double>& places, bool with_lines, Comparison& result) const;
  std::string compare_stages(const std::vector<double>& places, bool with_lines, Comparison& result) const;

  std::optional<Comparison> evaluate(const std::vector<double>& places, std::string& fault, bool with_lines) const;

  const input::Case& data_;
  const input::Calibration& calibration_;
  EvaluationStore* store_;
  std::vector<std::size_t> tests_;              ///< those with measurements
  std::vector<std::vector<std::size_t>> legs_;  ///< of every curve, for each point
  std::vector<double> spans_;                   ///< of every curve: range of its abscissae
  std::size_t value_count_ = 0;
  mutable std::atomic<long> runs_ = 0;
};

}  // namespace talus::laboratory
