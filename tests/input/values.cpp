// SPDX-License-Identifier: MIT
// Values read from a correct file, and rejected single values.

#include <filesystem>
#include <fstream>

#include "material/every_law.hpp"
#include "slope.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

TEST(CaseFile, BecomesSiUnitsAndRadians) {
  const Case data = read_case_text(slope, "slope.toml").data;
  const Material& sand = data.materials.at("sand");
  EXPECT_DOUBLE_EQ(sand.young_modulus, 45e6);
  EXPECT_DOUBLE_EQ(sand.cohesion, 2000);
  EXPECT_DOUBLE_EQ(sand.friction_angle, 30 * degree);
  EXPECT_DOUBLE_EQ(sand.density(), 2000);
  // E_c = λ + 2G, with λ = Eν/((1+ν)(1-2ν)) and 2G = E/(1+ν).
  EXPECT_NEAR(material::LinearElastic::make(sand).constrained_modulus(), 45e6 * 0.3 / (1.3 * 0.4) + 45e6 / 1.3, 1e-6);
  EXPECT_EQ(data.mesh.polygons.at(0).points.at(4), (std::array<double, 2>{12, 15}));
  EXPECT_EQ(data.boundaries.at(1).on, "left");
  EXPECT_EQ(data.boundaries.at(1).fix, Fix::normal);
  EXPECT_DOUBLE_EQ(data.stages.at(1).duration, 3);
  EXPECT_DOUBLE_EQ(data.stages.at(0).step.damping, 0.7);
}

TEST(CaseFile, KeepsTheDefaultsOfTheTwoKindsOfTrials) {
  const StrengthReduction reduction = read_case_text(slope, "slope.toml").data.strength_reduction;
  EXPECT_EQ(reduction.curve.step_settings.damping, 0.05);
  EXPECT_EQ(reduction.curve.step_settings.courant, 0.98);
  EXPECT_EQ(reduction.curve.step_settings.smoothing, Smoothing::none);
  EXPECT_EQ(reduction.curve.step_settings.geometry, Geometry::moving);
  EXPECT_EQ(reduction.frozen.step_settings.damping, 0.2);
  EXPECT_EQ(reduction.frozen.step_settings.courant, 0.9);
  EXPECT_EQ(reduction.frozen.step_settings.smoothing, Smoothing::stable);
  EXPECT_EQ(reduction.frozen.step_settings.geometry, Geometry::frozen);
}

TEST(CaseFile, MakesDirectionsUnitVectors) {
  const Case data = read_case_text(change(slope + "[gravity]\ndirection = [3, -4]\n", "fix = \"normal\"",
                                          "fix = \"plane\"\nnormal = [0, 5]"),
                                   "slope.toml")
                        .data;
  EXPECT_DOUBLE_EQ(data.gravity.direction[0], 0.6);
  EXPECT_DOUBLE_EQ(data.gravity.direction[1], -0.8);
  EXPECT_DOUBLE_EQ(data.boundaries.at(1).normal[1], 1);
}

TEST(CaseFile, ReadsTablesOfTimeWithUnits) {
  const Case data =
      read_case_text(change(slope, "fix = \"normal\"",
                            "fix = \"velocity\"\nvelocity = [\"10 cm/s\", 0]\nfactor = [[0, 0], [\"1 min\", 3]]"),
                     "slope.toml")
          .data;
  const Boundary& wall = data.boundaries.at(1);
  EXPECT_DOUBLE_EQ(wall.velocity[0], 0.1);
  EXPECT_DOUBLE_EQ(wall.factor.at(-1), 0);
  EXPECT_DOUBLE_EQ(wall.factor.at(20), 1);
  EXPECT_DOUBLE_EQ(wall.factor.at(60), 3);
  EXPECT_DOUBLE_EQ(wall.factor.at(100), 3);
  EXPECT_DOUBLE_EQ(TimeTable{}.at(5), 1) << "without a table the load is constant";
}

TEST(CaseFile, TakesFourPointsPerElementIn3D) {
  const std::string text = change(slope, "dimension = 2", "dimension = 3\nthickness = 5");
  EXPECT_EQ(read_case_text(text, "slope.toml").data.points_per_element, 4);
  EXPECT_EQ(read_case_text(slope, "slope.toml").data.points_per_element, 3);
}

TEST(CaseFile, FindsItsMeshBesideItself) {
  const std::string folder = support::make_scratch("case_folder").string();
  std::ofstream(folder + "/ready.msh") << "a mesh";
  const auto begin = slope.find("box ="), end = slope.find("[mesh]");
  const std::string text = change(std::string(slope).erase(begin, end - begin), "size = 0.75", "file = \"ready.msh\"");
  std::ofstream(folder + "/case.toml") << text;
  EXPECT_EQ(read_case(folder + "/case.toml").data.mesh.file, folder + "/ready.msh");
}

TEST(Value, OfTheWrongTypeIsRefused) {
  expect_fault("porosity = 0.2", "porosity = @@\"much\"", "'porosity' must be a number, not a text");
  expect_fault("size = 0.75", "size = @@true", "'size' must be a length (a number in m or a text such as \"2 m\")");
  expect_fault("dimension = 2", "dimension = @@2.0", "'dimension' must be a whole number");
  expect_fault("name = \"gravity\"", "name = @@3", "'name' must be a text in quotation marks, not a whole number");
  expect_fault("damping = 0.7", "objective_rate = @@\"yes\"", "'objective_rate' must be true or false");
  expect_fault("[[0, 0], [44, 17]]", "@@[0, 0, 44, 17]", "two corners");
  expect_fault("[12, 15], [0, 15]]", "[12, 15], @@[0, 15, 3]]", "must be points [x, y], not a list of 3");
  expect_fault("damping = 0.7", "until = @@1", "one of the words time, rest");
}

TEST(Value, OutOfItsRangeIsRefusedWithTheRange) {
  expect_fault("poisson_ratio = 0.3", "poisson_ratio = @@0.5",
               "'poisson_ratio' is 0.5; it must be above -1 and below 0.5");
  expect_fault("poisson_ratio = 0.3", "poisson_ratio = @@-1", "above -1 and below 0.5");
  expect_fault("cohesion = 2", "cohesion = @@\"-1 MPa\"", "'cohesion' is -1000 kPa; it must be at least 0 kPa");
  expect_fault("friction_angle = \"30 deg\"", "friction_angle = @@90", "below 90 deg");
  expect_fault("damping = 0.7", "damping = @@1", "at least 0 and below 1");
  expect_fault("damping = 0.7", "mass_scaling = @@0.5", "at least 1");
  expect_fault("damping = 0.7", "courant = @@0", "above 0 and at most 1");
  expect_fault("damping = 0.7", "courant = @@1.01", "above 0 and at most 1");
  expect_fault("duration = 10", "duration = @@0", "above 0 s");
  expect_fault("dimension = 2", "dimension = @@4", "at least 2 and at most 3");
}

TEST(Value, MustBeFinite) {
  expect_fault("cohesion = 2", "cohesion = @@inf", "'cohesion' must be a finite number");
  expect_fault("porosity = 0.2", "porosity = @@nan", "'porosity' must be a finite number");
}

TEST(Value, OfTheWrongDimensionIsRefused) {
  expect_fault("cohesion = 2", "cohesion = @@\"2 kg\"", "'2 kg' is a mass; cohesion needs a stress such as \"2 kPa\"");
  expect_fault("duration = 10", "duration = @@\"10\"", "'10' is a text without a unit; duration needs a time");
  expect_fault("cohesion = 2", "cohesion = @@\"2 kpa\"", "did you mean 'kPa'?");
}

TEST(Value, MustBeAKnownWord) {
  expect_fault("fix = \"full\"", "fix = @@\"ful\"", "did you mean 'full'?");
  expect_fault("fix = \"full\"", "fix = @@\"glued\"", "choose one of full, normal, plane, friction, velocity");
  expect_fault("model = \"mohr_coulomb\"", "model = @@\"mohr-coulomb\"", "did you mean 'mohr_coulomb'?");
}

TEST(Value, OfATimeTableMustIncreaseAndHavePairs) {
  const std::string wall = "fix = \"velocity\"\nvelocity = [1, 0]\nfactor = ";
  expect_fault("fix = \"normal\"", wall + "[[0, 0], [2, 1], @@[2, 3]]", "must increase");
  expect_fault("fix = \"normal\"", wall + "[[0, 0], @@[2]]", "rows [time, factor]");
  expect_fault("fix = \"normal\"", wall + "@@5", "rows [time, factor]");
}

}  // namespace
}  // namespace talus::input
