// SPDX-License-Identifier: MIT
// Calibration of parameters that the curves do not determine, at limits, and with soils that are rejected.

#include "base/error.hpp"
#include "laboratory/calibration_model.hpp"
#include "support/laboratory.hpp"
#include "support/slopes.hpp"

namespace talus::laboratory {
namespace {

using support::join_findings;
using support::Laboratory;
using support::spread;
using support::write_triaxial;

const std::string sand =
    support::write_slope("sand", {"materials.sand.cohesion=5", "materials.sand.dilatancy_angle=5"});

std::string write_sand_test(const std::string& name, double cell) {
  return "[[test]]\nname = \"" + name +
         "\"\nmaterial = \"sand\"\nkind = \"drained_triaxial\"\nconfining_pressure = " + std::to_string(cell) +
         "\naxial_strain = 0.05\nsteps = 100\n";
}

/// κ and λ of bare loess from a triaxial test of normally consolidated soil, and from an isotropic one too.
Laboratory make_clay(bool with_compression) {
  Laboratory lab(support::loess + write_triaxial("shear", 200, 0) + support::isotropic);
  for (const char* y : {"q", "volumetric_strain"}) lab.measure("shear", "axial_strain", y, spread(0, 0.2, 10));
  if (with_compression) {
    lab.measure("isotropic", "p", "void_ratio",
                {50e3, 100e3, 150e3, 250e3, 400e3, 200e3, 100e3, 200e3, 400e3, 600e3, 800e3});
    lab.calibration().curves.back().deviation = 0.002;
  }
  lab.fit("loess.kappa", 0.03, 0.004, 0.06);
  lab.fit("loess.lambda", 0.12, 0.03, 0.3);
  return lab;
}

TEST(CalibrationLimits, CompressionSeparatesKappaFromLambdaAndShearingHardly) {
  const results::Calibration shear = make_clay(false).calibrate(), both = make_clay(true).calibrate();
  ASSERT_TRUE(shear.correlation[0][1].has_value());
  EXPECT_GT(*shear.correlation[0][1], 0.9);
  EXPECT_LT(std::abs(both.correlation[0][1].value()), 0.3);
  EXPECT_TRUE(both.findings.empty()) << join_findings(both);
  EXPECT_NEAR(both.parameters[0].value, 0.022, 1e-4);
  EXPECT_NEAR(both.parameters[1].value, 0.089, 1e-4);
}

TEST(CalibrationLimits, OneCellPressureDoesNotFixCohesionAndFriction) {
  Laboratory one(sand + write_sand_test("a", 100)), two(sand + write_sand_test("a", 100) + write_sand_test("b", 300));
  for (Laboratory* lab : {&one, &two}) {
    lab->measure("a", "axial_strain", "q", spread(0, 0.05, 10));
    lab->fit("sand.cohesion", 1e3, 0, 50e3);
    lab->fit("sand.friction_angle", 0.4, 0.2, 0.8);
  }
  two.measure("b", "axial_strain", "q", spread(0, 0.05, 10));
  const results::Calibration unfixed = one.calibrate(), fixed = two.calibrate();
  EXPECT_NE(join_findings(unfixed).find(
                "determine only a combination of 'materials.sand.cohesion' and 'materials.sand.friction_angle'"),
            std::string::npos)
      << join_findings(unfixed);
  EXPECT_FALSE(unfixed.parameters[0].error.has_value());
  EXPECT_NEAR(fixed.parameters[0].value, 5e3, 5);
  EXPECT_NEAR(fixed.parameters[1].value, M_PI / 6, 1e-3);
  EXPECT_TRUE(fixed.findings.empty()) << join_findings(fixed);
}

TEST(CalibrationLimits, SimilarCellPressuresHardlySeparateCohesionFromFriction) {
  Laboratory lab(sand + write_sand_test("a", 100) + write_sand_test("b", 115));
  for (const char* test : {"a", "b"}) lab.measure(test, "axial_strain", "q", spread(0, 0.05, 10));
  lab.fit("sand.cohesion", 1e3, 0, 50e3);
  lab.fit("sand.friction_angle", 0.4, 0.2, 0.8);
  const results::Calibration result = lab.calibrate();
  EXPECT_LT(result.correlation[0][1].value(), -0.95) << "cohesion makes up for friction";
  EXPECT_NE(join_findings(result).find("These curves hardly separate 'materials.sand.cohesion' and "
                                       "'materials.sand.friction_angle' (correlation -0.99"),
            std::string::npos)
      << join_findings(result);
  EXPECT_NEAR(result.parameters[0].value, 5e3, 10);
}

TEST(CalibrationLimits, AParameterThatNothingFeelsIsNamed) {
  Laboratory lab(sand + write_sand_test("a", 100));
  lab.measure("a", "axial_strain", "q", spread(0, 0.05, 10));
  lab.fit("sand.friction_angle", 0.4, 0.2, 0.8);
  lab.fit("sand.dilatancy_angle", 0.1, 0, 0.2);
  const results::Calibration result = lab.calibrate();
  EXPECT_NE(join_findings(result).find("do not depend on 'materials.sand.dilatancy_angle'"), std::string::npos)
      << join_findings(result);
  EXPECT_NEAR(result.parameters[0].value, M_PI / 6, 1e-3) << "the others are still found";
}

TEST(CalibrationLimits, AParameterAtItsLimitIsReported) {
  Laboratory lab(sand + write_sand_test("a", 100) + write_sand_test("b", 300));
  for (const char* test : {"a", "b"}) lab.measure(test, "axial_strain", "q", spread(0, 0.05, 10));
  lab.fit("sand.cohesion", 1e3, 0, 50e3);
  lab.fit("sand.friction_angle", 0.3, 0.2, 0.45);
  const results::Calibration result = lab.calibrate();
  EXPECT_EQ(result.parameters[1].limit, results::AtLimit::high);
  EXPECT_DOUBLE_EQ(result.parameters[1].value, 0.45);
  EXPECT_FALSE(result.parameters[1].error.has_value());
  EXPECT_TRUE(result.parameters[0].error.has_value()) << "the other one has an error";
  EXPECT_NE(join_findings(result).find("'materials.sand.friction_angle' ended at its largest value, 0.45"),
            std::string::npos)
      << join_findings(result);
}

TEST(CalibrationLimits, SoilsThatTheCaseRefusesAreGoneRound) {
  Laboratory lab = make_clay(true);
  lab.calibration().parameters[0] = {.key = "materials.loess.kappa",
                                     .start = {},
                                     .min = {},
                                     .max = {},
                                     .material = "loess",
                                     .path = "kappa",
                                     .unit = "",
                                     .first = 0.1,
                                     .low = 0.001,
                                     .high = 0.3};
  lab.calibration().starts = 4;
  const results::Calibration result = lab.calibrate();
  EXPECT_EQ(result.starts.size(), 4u) << "random starts with κ above λ are drawn again";
  EXPECT_NEAR(result.parameters[0].value, 0.022, 1e-4);
  EXPECT_NEAR(result.parameters[1].value, 0.089, 1e-4);
  lab.calibration().parameters[0].first = 0.2;
  try {
    lab.calibrate();
    ADD_FAILURE() << "κ above λ was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("cannot begin at the values of 'start': 'kappa' is 0.2"),
              std::string::npos)
        << error.what();
  }
}

TEST(CalibrationLimits, ASoilTooWeakForTheTestStillShowsTheWay) {
  // Under stress control a soil with M = 1.1 gives way at q = 174 kPa; measured is up to 250 kPa.
  Laboratory lab(support::loess + R"([[test]]
name = "creep"
material = "loess"
kind = "drained_triaxial"
confining_pressure = 100
control = "stress"
axial_stress = 350
steps = 200
)");
  lab.measure("creep", "q", "axial_strain", spread(0, 250e3, 10));
  lab.fit("loess.critical_state_slope", 1.1, 0.8, 1.8);
  const CalibrationModel model(lab.data());
  const auto weak = model.compare({model.find_place(0, 1.1)}), weaker = model.compare({model.find_place(0, 0.9)});
  ASSERT_TRUE(weak.has_value() && weaker.has_value());
  EXPECT_GT(weak->missing[0], 0.05);
  EXPECT_GT(weaker->missing[0], weak->missing[0]);
  EXPECT_GT(weak->residuals.back(), 100) << "more than any that is reached";
  EXPECT_GT(weaker->residuals.back(), weak->residuals.back()) << "the way to a stronger soil";
  const results::Calibration result = lab.calibrate();
  EXPECT_NEAR(result.parameters[0].value, 1.42, 2e-3);
  EXPECT_LT(result.curves[0].missing, 1e-6);
}

TEST(CalibrationLimits, ThreadsChangeNothing) {
  Laboratory lab = make_clay(true);
  lab.calibration().starts = 2;
  const results::Calibration one = lab.calibrate(1), four = lab.calibrate(4);
  EXPECT_EQ(one.parameters[0].value, four.parameters[0].value);
  EXPECT_EQ(one.starts[1].to, four.starts[1].to);
  EXPECT_EQ(one.evaluations, four.evaluations);
}

TEST(CalibrationLimits, CurvesOfNoWeightAreShownAndNotFitted) {
  Laboratory lab = make_clay(true);
  lab.calibration().curves[2].weight = 0;
  for (auto& point : lab.calibration().curves[2].points) point[1] *= 2;
  const results::Calibration result = lab.calibrate();
  EXPECT_EQ(result.values, 20u);
  EXPECT_NEAR(result.parameters[1].value, 0.089, 1e-4);
  EXPECT_GT(result.curves[2].rms, 0.5) << "void ratio";
}

TEST(CalibrationLimits, ATestKeepsTheNumberThatItSets) {
  // The second specimen is weaker by its `set`, which the fit must not change.
  Laboratory lab(sand + write_sand_test("a", 100) + write_sand_test("b", 100) + "set = { friction_angle = 20 }\n");
  for (const char* test : {"a", "b"}) lab.measure(test, "axial_strain", "q", spread(0, 0.05, 10));
  lab.fit("sand.friction_angle", 0.4, 0.2, 0.8);
  const results::Calibration result = lab.calibrate();
  EXPECT_NEAR(result.parameters[0].value, M_PI / 6, 1e-6);
  EXPECT_LT(result.curves[1].rms_before, 1) << "Pa: right from the start";
}

TEST(CalibrationLimits, TheBestOfTheSearchesCounts) {
  Laboratory lab = make_clay(true);
  lab.calibration().starts = 5;
  lab.calibration().iterations = 2;  // too few, so that they end apart
  const results::Calibration result = lab.calibrate();
  double least = INFINITY, most = 0;
  for (const results::CalibrationSearch& start : result.starts) {
    least = std::min(least, start.misfit);
    most = std::max(most, start.misfit);
  }
  EXPECT_GT(most, 2 * least);
  EXPECT_EQ(result.starts[result.best].misfit, least);
  EXPECT_EQ(result.parameters[0].value, result.starts[result.best].to[0]);
  EXPECT_NE(join_findings(result).find("did not converge"), std::string::npos) << join_findings(result);
}

TEST(MeasuredLegs, PointsOfUnloadingAreReadOnUnloading) {
  Laboratory lab(support::loess + support::isotropic);
  const input::PointTest& test = lab.data().tests[0];
  const std::vector<std::array<double, 2>> points{{60e3, 0},  {200e3, 0}, {190e3, 0}, {400e3, 0}, {200e3, 0},
                                                  {205e3, 0}, {110e3, 0}, {200e3, 0}, {700e3, 0}};
  // A slip backwards is not a turn. A point at a turn belongs to either leg.
  const std::vector<std::size_t> legs = find_legs(test, points);
  EXPECT_EQ((std::vector<std::size_t>{legs[0], legs[1], legs[2], legs[4], legs[5], legs[7], legs[8]}),
            (std::vector<std::size_t>{0, 0, 0, 1, 1, 2, 2}));
  input::PointTest fine = test;
  fine.steps = 4000;
  const PointCurve curve = run_point_test(lab.data().test_soils[0], fine);
  // Slopes of Cam-clay: e falls by λ ln(400/125) beyond the preconsolidation and comes back by κ.
  const double first = 0.86 - 0.022 * std::log(125.0 / 50), at_400 = first - 0.089 * std::log(400.0 / 125);
  EXPECT_NEAR(read_curve(curve, 0, "p", "void_ratio", 200e3).y, first - 0.089 * std::log(200.0 / 125), 1e-4);
  EXPECT_NEAR(read_curve(curve, 1, "p", "void_ratio", 200e3).y, at_400 + 0.022 * std::log(2.0), 1e-4);
  EXPECT_NEAR(read_curve(curve, 2, "p", "void_ratio", 600e3).y, at_400 - 0.089 * std::log(1.5), 1e-4);
  const Reading beyond = read_curve(curve, 2, "p", "void_ratio", 900e3);
  EXPECT_NEAR(beyond.missing, 100e3, 1);
  EXPECT_NEAR(beyond.y, at_400 - 0.089 * std::log(2.0), 1e-4);
}

}  // namespace
}  // namespace talus::laboratory
