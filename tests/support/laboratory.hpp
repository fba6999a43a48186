// SPDX-License-Identifier: MIT
#pragma once
// Synthetic laboratory curves of known parameters for the tests of calibration, with optional errors.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "input/read.hpp"
#include "laboratory/calibration.hpp"
#include "laboratory/calibration_model.hpp"

namespace talus::support {

/// Table 4.1 of the source.
inline const std::string loess = R"(
[materials.loess]
model = "rooted_cam_clay"
grain_density = 2700
void_ratio = 0.86
poisson_ratio = 0.30
lambda = 0.089
kappa = 0.022
critical_state_slope = 1.42
preconsolidation = 125
root_content = 0
root_hardening = 0.28
root_strength = 0.18
)";

inline std::string write_triaxial(const std::string& name, double cell, double roots) {
  return "[[test]]\nname = \"" + name +
         "\"\nmaterial = \"loess\"\nkind = \"drained_triaxial\"\nconfining_pressure = " + std::to_string(cell) +
         "\naxial_strain = 0.2\nsteps = 200\nset = { root_content = " + std::to_string(roots) + " }\n";
}

inline const std::string isotropic = R"([[test]]
name = "isotropic"
material = "loess"
kind = "isotropic_compression"
confining_pressure = 50
control = "stress"
axial_stress = [400, 100, 800]
steps = 200
)";

/// `count` values after `from` up to `to`.
inline std::vector<double> spread(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 1; i <= count; ++i) values.push_back(from + (to - from) * i / count);
  return values;
}

/// A case of soils and tests whose own parameters give the measured curves.
class Laboratory {
 public:
  explicit Laboratory(const std::string& text)
      : data_(
            input::read_case_text("title = \"Laboratory\"\n" + text, "case.toml", {}, input::CaseScope::whole_or_tests)
                .data) {
    data_.calibration.emplace();
    data_.calibration->starts = 1;
  }

  /// `key` is "loess.kappa"; numbers are SI.
  void fit(const std::string& key, double first, double low, double high,
           input::CalibrationScale scale = input::CalibrationScale::linear) {
    const auto dot = key.find('.');
    input::CalibrationParameter p;
    p.key = "materials." + key, p.material = key.substr(0, dot), p.path = key.substr(dot + 1);
    p.first = first, p.low = low, p.high = high, p.scale = scale;
    data_.calibration->parameters.push_back(p);
  }

  /// Measures y at the abscissae, without error; errors of 2 % of its largest value are stated.
  void measure(const std::string& test, const std::string& x, const std::string& y, const std::vector<double>& at) {
    input::MeasuredCurve c;
    c.test = test, c.x = x, c.y = y;
    while (data_.tests.at(c.test_number).name != test) ++c.test_number;
    const input::PointTest& which = data_.tests[c.test_number];
    const laboratory::PointCurve curve = laboratory::run_point_test(data_.test_soils[c.test_number], which);
    for (const double value : at) c.points.push_back({value, 0});
    const std::vector<std::size_t> legs = laboratory::find_legs(which, c.points);
    double largest = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const laboratory::Reading reading = laboratory::read_curve(curve, legs[i], x, y, at[i]);
      EXPECT_LT(reading.missing, 1e-6 * std::abs(at[i])) << test << ": the true soil must reach what is measured";
      c.points[i][1] = reading.y;
      largest = std::max(largest, std::abs(reading.y));
    }
    c.deviation = 0.02 * largest;
    true_.push_back(c.points);
    data_.calibration->curves.push_back(std::move(c));
  }

  /// Gives every measured value an error, normally distributed as stated.
  void disturb(std::mt19937_64& engine) {
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < true_.size(); ++k) {
      input::MeasuredCurve& c = data_.calibration->curves[k];
      for (std::size_t i = 0; i < c.points.size(); ++i) c.points[i][1] = true_[k][i][1] + c.deviation * normal(engine);
    }
  }

  input::Case& data() { return data_; }
  input::Calibration& calibration() { return *data_.calibration; }
  results::Calibration calibrate(int threads = 2) { return laboratory::calibrate(data_, {threads, nullptr}); }

 private:
  input::Case data_;
  std::vector<std::vector<std::array<double, 2>>> true_;
};

/// All findings, a line each.
inline std::string join_findings(const results::Calibration& result) {
  std::string text;
  for (const std::string& sentence : result.findings) text += sentence + "\n";
  return text;
}

}  // namespace talus::support
