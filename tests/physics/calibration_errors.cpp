// SPDX-License-Identifier: MIT
// Calibration on curves of known parameters (Table 4.1 of the source, four root contents), without errors and with
// errors of 2 %.

#include "support/laboratory.hpp"

namespace talus::laboratory {
namespace {

using support::Laboratory;
using support::spread;
using support::write_triaxial;

const std::array<double, 4> truth{0.022, 0.089, 0.28, 0.18};

/// κ, λ, R_p and R_a from triaxial tests at 100, 200 and 300 kPa.
Laboratory make_rooted() {
  Laboratory lab(support::loess + write_triaxial("a", 100, 0) + write_triaxial("b", 200, 0.22) +
                 write_triaxial("c", 300, 0.44) + write_triaxial("d", 100, 0.88));
  for (const char* test : {"a", "b", "c", "d"})
    for (const char* y : {"q", "volumetric_strain"}) lab.measure(test, "axial_strain", y, spread(0, 0.2, 10));
  lab.fit("loess.kappa", 0.01, 0.004, 0.05);
  lab.fit("loess.lambda", 0.15, 0.05, 0.3);
  lab.fit("loess.root_hardening", 0.6, 0, 1);
  lab.fit("loess.root_strength", 0.05, 0, 1);
  return lab;
}

TEST(CalibrationErrors, WithoutErrorsTheParametersComeBack) {
  Laboratory lab = make_rooted();
  lab.calibration().starts = 3;
  const results::Calibration result = lab.calibrate();
  ASSERT_EQ(result.parameters.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(result.parameters[i].value, truth[i], 1e-3 * truth[i]) << result.parameters[i].key;
    EXPECT_EQ(result.parameters[i].limit, results::AtLimit::no);
  }
  EXPECT_EQ(result.values, 80u);
  for (const results::CalibratedCurve& c : result.curves)
    EXPECT_LT(c.rms, 1e-5 * c.rms_before) << c.test << " " << c.y.name;
  // Searches from elsewhere end at the same place.
  for (const results::CalibrationSearch& start : result.starts)
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(start.to[i], truth[i], 1e-3 * truth[i]) << i;
  EXPECT_TRUE(result.findings.empty()) << support::join_findings(result);
  EXPECT_LT(result.evaluations, 1000);
}

TEST(CalibrationErrors, StandardErrorsAreThoseOfRepeatedMeasurements) {
  Laboratory lab = make_rooted();
  for (std::size_t i = 0; i < 4; ++i) lab.calibration().parameters[i].first = 1.2 * truth[i];
  constexpr int repeats = 30;
  std::mt19937_64 engine(7);
  std::array<double, 4> sum{}, squares{}, stated{};
  double scatter = 0, product = 0, correlation = 0;
  int beyond = 0;
  for (int r = 0; r < repeats; ++r) {
    lab.disturb(engine);
    const results::Calibration result = lab.calibrate();
    std::array<double, 4> off{};
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(result.parameters[i].error.has_value());
      off[i] = result.parameters[i].value - truth[i];
      const double error = *result.parameters[i].error;
      EXPECT_LT(std::abs(off[i]), 4 * error) << result.parameters[i].key << " in repeat " << r;
      beyond += std::abs(off[i]) > 3 * error ? 1 : 0;
      sum[i] += off[i];
      squares[i] += off[i] * off[i];
      stated[i] += error / repeats;
    }
    product += off[0] * off[1];
    correlation += result.correlation[0][1].value() / repeats;
    scatter += result.scatter / repeats;
  }
  EXPECT_LE(beyond, 3) << "of 120; 0.3 are expected beyond three standard errors";
  // The stated errors are the true ones here, so that the differences are one of them.
  EXPECT_NEAR(scatter, 1, 0.05);
  for (std::size_t i = 0; i < 4; ++i) {
    const double mean = sum[i] / repeats, deviation = std::sqrt((squares[i] - sum[i] * mean) / (repeats - 1));
    EXPECT_LT(deviation / stated[i], 1.5) << i;
    EXPECT_GT(deviation / stated[i], 1 / 1.5) << i;
    EXPECT_LT(std::abs(mean), 3 * stated[i] / std::sqrt(repeats)) << i << ": a bias";
  }
  const double found = product / std::sqrt(squares[0] * squares[1]);
  EXPECT_NEAR(found, correlation, 0.4) << "correlation of κ and λ, as found and as stated";
}

TEST(CalibrationErrors, ErrorsFollowTheScatterAndNotTheStatedErrors) {
  Laboratory lab = make_rooted();
  std::mt19937_64 engine(3);
  lab.disturb(engine);
  const results::Calibration once = lab.calibrate();
  double sum = 0;
  for (const results::CalibratedCurve& c : once.curves)
    for (std::size_t i = 0; i < c.at.size(); ++i) sum += std::pow((c.fitted[i] - c.measured[i]) / c.deviation, 2);
  EXPECT_NEAR(once.scatter, std::sqrt(sum / (80 - 4)), 1e-9) << "over the degrees of freedom";
  for (auto& c : lab.calibration().curves) c.deviation /= 10;
  const results::Calibration strict = lab.calibrate();
  EXPECT_NEAR(strict.scatter, 10 * once.scatter, 1e-3 * strict.scatter);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(strict.parameters[i].value, once.parameters[i].value, 1e-4 * truth[i]);
    EXPECT_NEAR(*strict.parameters[i].error, *once.parameters[i].error, 1e-2 * *once.parameters[i].error);
  }
}

}  // namespace
}  // namespace talus::laboratory
