// SPDX-License-Identifier: MIT
// Checks between the keys of a case.

#include "slope.hpp"

namespace talus::input {
namespace {

TEST(Regions, NeedAMaterialThatExists) {
  expect_fault(change(change(slope, "soil = \"sand\"", ""), "[regions]", "@@[regions]"),
               "region 'soil' has no material");
}

TEST(Regions, ReportMistypedNames) {
  expect_fault("soil = \"sand\"", "soil = @@\"snad\"", "there is no material 'snad'; did you mean 'sand'?");
  expect_fault("soil = \"sand\"", "soil = \"sand\"\nsoli = @@\"sand\"",
               "there is no region 'soli'; did you mean 'soil'?");
  expect_fault(slope + "[initial.velocity]\nrock = @@[1, 0]\n", "there is no region 'rock'; known: soil");
}

TEST(Materials, ThatNoRegionUsesAreAWarning) {
  const LoadedCase loaded =
      read_case_text(change(slope, "[materials.sand]",
                            "[materials.rock]\nmodel = \"linear_elastic\"\ngrain_density = 2700\nporosity = 0.1\n"
                            "young_modulus = 1e6\npoisson_ratio = 0.2\n\n[materials.sand]"),
                     "slope.toml");
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_EQ(loaded.warnings[0].line, 18);
  EXPECT_EQ(loaded.warnings[0].sentence, "material 'rock' is not used: no region in [regions] has it");
}

TEST(Materials, CannotCarryMoreTensionThanTheApex) {
  // c/tan φ = 2/tan 30° = 3.464 kPa
  expect_fault("tensile_strength = 0", "tensile_strength = @@3.47", "cohesion/tan(friction_angle) = 3.4641 kPa");
  EXPECT_TRUE(find_faults(change(slope, "tensile_strength = 0", "tensile_strength = 3.46")).empty());
  EXPECT_TRUE(find_faults(change(slope, "tensile_strength = 0", "tensile_strength = 3.46411")).empty())
      << "the apex, rounded up to six digits";
  const std::string clay = change(slope, "friction_angle = \"30 deg\"", "friction_angle = 0");
  EXPECT_TRUE(find_faults(change(clay, "tensile_strength = 0", "tensile_strength = 50")).empty()) << "no apex at φ = 0";
}

TEST(Materials, CannotDilateMoreThanTheyRub) {
  expect_fault("dilatancy_angle = 0", "dilatancy_angle = @@31", "must not be greater than the friction angle, 30 deg");
  EXPECT_TRUE(find_faults(change(slope, "dilatancy_angle = 0", "dilatancy_angle = 30")).empty());
}

TEST(Monitors, HaveNamesThatCanHeadAColumn) {
  expect_fault(slope + "[[output.monitor]]\nname = @@\"crest, left\"\nat = [12, 15]\n", "must not hold commas");
}

TEST(Sides, MustExist) {
  expect_fault("on = \"bottom\"", "on = @@\"botom\"",
               "there is no side or line 'botom'; did you mean 'bottom'? known: bottom, crest, left, right, top");
  expect_fault("on = \"bottom\"", "on = @@\"back\"", "there is no side or line 'back'");
  expect_fault(slope + "[[traction]]\non = @@\"roof\"\ntraction = [0, -20]\n", "there is no side or line 'roof'");
  EXPECT_TRUE(find_faults(change(slope, "on = \"bottom\"", "on = \"crest\"")).empty());
  EXPECT_TRUE(find_faults(change(change(slope, "on = \"bottom\"", "on = \"back\""), "dimension = 2",
                                 "dimension = 3\nthickness = 2"))
                  .empty());
}

TEST(Names, MustDiffer) {
  expect_fault("name = \"failure\"", "name = @@\"gravity\"", "there are two stages named 'gravity'");
  expect_fault("name = \"crest\"", "name = @@\"left\"", "two sides or lines named 'left'");
  expect_fault("[[geometry.line]]",
               "[[geometry.polygon]]\nname = @@\"soil\"\npoints = [[0, 15], [1, 15], [0, 16]]\n[[geometry.line]]",
               "there are two polygons named 'soil'");
  expect_fault(
      slope + "[[output.monitor]]\nname = \"a\"\nat = [0, 0]\n[[output.monitor]]\nname = @@\"a\"\nat = [1, 0]\n",
      "two monitors named 'a'");
}

TEST(Polygon, NeedsThreeCornersThatAreNotRepeated) {
  const std::string corners = "[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]";
  expect_fault(corners, "@@[[0, 0], [44, 0]]", "polygon 'soil' has 2 points; it needs at least 3");
  expect_fault(corners, "[[0, 0], [44, 0], @@[44, 0], [44, 5]]", "repeats its point (44, 0)");
  expect_fault(corners, "[[0, 0], @@[44, 0], [20, 0]]", "turns back on itself at (44, 0)");
}

TEST(Polygon, MayEndWithItsFirstCorner) {
  const std::string closed = change(slope, "[0, 15]]", "[0, 15], [0, 0]]");
  EXPECT_EQ(read_case_text(closed, "slope.toml").data.mesh.polygons[0].points,
            read_case_text(slope, "slope.toml").data.mesh.polygons[0].points);
}

TEST(Polygon, MustNotCrossItselfNorLeaveTheBox) {
  const std::string corners = "[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]";
  expect_fault(corners, "[[0, 0], [10, 10], @@[10, 0], [0, 10]]",
               "crosses itself: its side from (0, 0) to (10, 10) meets that from (10, 0) to (0, 10)");
  expect_fault(corners, "[[0, 0], [10, 0], @@[10, 10], [5, 0], [0, 10]]", "crosses itself");
  expect_fault(corners, "[[0, 0], [44, 0], @@[44, 18], [0, 15]]",
               "the point (44, 18) of polygon 'soil' is outside the box");
}

TEST(PointsPerElement, DependOnTheDimension) {
  expect_fault("size = 0.75", "size = 0.75\npoints_per_element = @@4", "in 2D it must be 1, 3, 6 or 12");
  expect_fault(change(change(slope, "dimension = 2", "dimension = 3\nthickness = 5"), "size = 0.75",
                      "size = 0.75\npoints_per_element = @@3"),
               "in 3D it must be 1, 4, 8 or 10");
}

TEST(Directions, MustHaveALengthAndLieInThePlane) {
  expect_fault(slope + "[gravity]\ndirection = @@[0, 0]\n", "'direction' is zero");
  expect_fault(slope + "[gravity]\ndirection = @@[0, -1, 1]\n", "third component of 'direction' must be 0 in 2D");
  expect_fault("fix = \"full\"", "fix = \"plane\"\nnormal = @@[0, 0]", "'normal' is zero");
}

TEST(Stages, AreNeeded) {
  expect_fault("@@" + slope.substr(0, slope.find("[[stage]]")), "there is no stage");
  expect_fault("damping = 0.7", "gravity_ramp = @@11", "must not be longer than the stage, 10 s");
}

TEST(Reading, OfAnElasticCaseNeedsNoStrength) {
  const std::string elastic =
      change(change(slope, "model = \"mohr_coulomb\"", "model = \"linear_elastic\""),
             "cohesion = 2\nfriction_angle = \"30 deg\"\ndilatancy_angle = 0\ntensile_strength = 0\n", "");
  EXPECT_TRUE(find_faults(elastic).empty());
  expect_fault(elastic + "cohesion = @@2\n", "'cohesion' needs a material with model = \"mohr_coulomb\"");
  expect_fault(elastic + "[analysis]\nkind = @@\"strength_reduction\"\n", "strength reduction needs a material");
}

TEST(StrengthReduction, NeedsAnIntervalOfFactors) {
  const std::string curve = "[strength_reduction.curve]\n";
  expect_fault(slope + curve + "from = @@2\nto = 1.5\n", "'from' is 2 and 'to' is 1.5; 'from' must be smaller");
  expect_fault(slope + "[strength_reduction.frozen]\nto = @@1.0\n", "'from' is 1 and 'to' is 1");
  expect_fault(slope + curve + "initial_branch = @@[1.2, 1.1]\n", "'initial_branch' must be [from, to]");
  expect_fault(slope + curve + "step = @@0.005\n", "'refine_step' must not be larger");
  expect_fault(slope + "[analysis]\nkind = \"strength_reduction\"\n" + curve +
                   "enabled = false\n[strength_reduction.frozen]\nenabled = @@false\n",
               "one must be enabled");
}

TEST(Output, NeedsUnitsOfLengthAndStress) {
  expect_fault(slope + "[output]\nlength_unit = @@\"kPa\"\n", "'length_unit' is 'kPa'; it must be a unit of length");
  expect_fault(slope + "[output]\nstress_unit = @@\"kpa\"\n", "must be a unit of stress, such as \"kPa\"");
  EXPECT_TRUE(find_faults(slope + "[output]\nlength_unit = \"ft\"\nstress_unit = \"psi\"\n").empty());
}

TEST(Study, MustSetKeysAndValuesThatAreRight) {
  const std::string vary = slope + "[[study.vary]]\nkey = ";
  EXPECT_TRUE(find_faults(vary + "\"materials.sand.cohesion\"\nvalues = [2, \"3 kPa\", 4.5]\n").empty());
  expect_fault(vary + "\"materials.sand.cohesoin\"\nvalues = [@@2, 3]\n", "did you mean 'cohesion'?");
  expect_fault(vary + "\"materials.sand.cohesion\"\nvalues = [2, @@\"3 kg\"]\n", "'3 kg' is a mass");
  expect_fault(vary + "\"materials.sand.tensile_strength\"\nvalues = [1, 2, @@4]\n", "apex of the yield surface");
  expect_fault(vary + "\"stage.gravty.duration\"\nvalues = [@@1]\n", "'stage' has no entry 'gravty'");
}

TEST(Study, KeepsItsValuesAsTomlTexts) {
  const Case data =
      read_case_text(slope + "[[study.vary]]\nkey = \"materials.sand.cohesion\"\nvalues = [2, \"3 kPa\", 4.5]\n",
                     "slope.toml")
          .data;
  EXPECT_EQ(data.study.vary.at(0).values, (std::vector<std::string>{"2", "\"3 kPa\"", "4.5"}));
}

TEST(ReadyMesh, IsCheckedWhenItsNamesAreRead) {
  const LoadedCase loaded = read_case_text(slope, "slope.toml");
  EXPECT_NO_THROW(check_against_mesh(loaded, {"left", "right", "bottom", "top"}, {"soil"}));
  try {
    check_against_mesh(loaded, {"left", "base"}, {"soil", "rock"});
    FAIL() << "a side and a region without counterpart were accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 2u);
    EXPECT_EQ(error.diagnostics()[0].line, 29) << "[regions]";
    EXPECT_NE(error.diagnostics()[0].sentence.find("region 'rock' has no material"), std::string::npos);
    EXPECT_EQ(error.diagnostics()[1].line, 33);
    EXPECT_NE(error.diagnostics()[1].sentence.find("there is no side or line 'bottom'"), std::string::npos);
  }
}

TEST(ReadyMesh, ExcludesPolygonsAndMustExist) {
  const std::string text = change(slope, "size = 0.75", "file = \"missing.msh\"");
  const auto faults = find_faults(text);
  std::string all;
  for (const Diagnostic& fault : faults) all += to_string(fault) + "\n";
  for (const char* part : {"'box' in [geometry] has no meaning where 'mesh.file' is given",
                           "[[geometry.polygon]] has no meaning", "'missing.msh' does not exist"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
}

}  // namespace
}  // namespace talus::input
