// SPDX-License-Identifier: MIT
#pragma once
// Differences between the element tests of a case and what was measured, as a function of its parameters.

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "laboratory/point_results.hpp"
#include "laboratory/point_test.hpp"

namespace talus::laboratory {

// Where measured points lie on the calculated curve of an element test.

/// Which leg of the test each point belongs to: legs of loading and unloading cross the same abscissa. Points are in
/// the order of the measurement, so that only the places of the turns are open; they are those with the least way in
/// the wrong direction. All zero where the test has one leg.
std::vector<std::size_t> find_legs(const input::PointTest& test, const std::vector<std::array<double, 2>>& points);

/// The ordinate of the curve at an abscissa.
struct Reading {
  double y = 0;
  double missing = 0;  ///< the abscissa lies so far beyond what the leg reaches, and `y` is that of its nearest end
};

/// The first place on `leg` with the abscissa x.
Reading read_curve(const PointCurve& curve, std::size_t leg, const std::string& x_name, const std::string& y_name,
                   double x);

/// What one set of parameters gives.
struct Comparison {
  std::vector<double> residuals;            ///< of the fitted curves: w (y_model - y)/σ
  std::vector<std::vector<double>> values;  ///< of every curve: y_model at the measured abscissae [SI]
  std::vector<double> missing;              ///< of every curve: mean share of its abscissae that is not reached [-]
  std::vector<std::vector<results::Point>> lines;  ///< of every curve, thinned; only when asked for [SI]
};

class CalibrationModel {
 public:
  /// `data` must hold a calibration and outlive this.
  explicit CalibrationModel(const input::Case& data);

  std::size_t count_parameters() const { return calibration_.parameters.size(); }
  /// Measured values that are fitted; each has a residual.
  std::size_t count_values() const { return value_count_; }

  /// The parameter `i` at the place u of its range, 0 … 1; and the way back.
  double find_value(std::size_t i, double u) const;
  std::vector<double> find_values(const std::vector<double>& places) const;
  double find_place(std::size_t i, double value) const;
  /// d value/d u.
  double find_slope(std::size_t i, double u) const;

  /// Runs the tests with the parameters at `places`. Nothing when the case refuses them or a test cannot be run; then
  /// `why` says in a sentence why. Safe to call from several threads.
  std::optional<Comparison> compare(const std::vector<double>& places, std::string* why = nullptr,
                                    bool with_lines = false) const;
  /// Tests that were run so far.
  long count_runs() const { return runs_; }

 private:
  input::Material make_soil(std::size_t test, const std::vector<double>& places) const;

  const input::Case& data_;
  const input::Calibration& calibration_;
  std::vector<std::size_t> tests_;              ///< those that were measured
  std::vector<std::vector<std::size_t>> legs_;  ///< of every curve, of its points
  std::vector<double> spans_;                   ///< of every curve: what its abscissae cover
  std::size_t value_count_ = 0;
  mutable std::atomic<long> runs_ = 0;
};

}  // namespace talus::laboratory
