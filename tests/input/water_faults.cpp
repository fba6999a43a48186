// SPDX-License-Identifier: MIT
// Rejected input of pore water, and the messages.

#include "wet_slope.hpp"

namespace talus::input {
namespace {

const std::string crest = "on = \"crest\"\ncondition = \"seepage_face\"";

std::string start(const std::string& keys) {
  return change(wet_slope, "pore_pressure = \"seepage\"", keys);
}

TEST(WetSlope, ReadsWithoutFindings) {
  const auto faults = find_faults(wet_slope);
  EXPECT_TRUE(faults.empty()) << InputError(faults).what();
}

TEST(Saturation, HasLimitsInOrder) {
  expect_wet_fault("minimum_saturation = 0.15", "minimum_saturation = @@0.5\nmaximum_saturation = 0.4",
                   "'minimum_saturation' is 0.5 and 'maximum_saturation' is 0.4; the minimum must be smaller");
  expect_wet_fault("minimum_saturation = 0.15", "maximum_saturation = @@1.1", "above 0 and at most 1");
  expect_wet_fault("minimum_saturation = 0.15", "minimum_saturation = @@-0.1", "at least 0 and below 1");
}

TEST(VanGenuchten, NeedsItsLambdaBetweenZeroAndOne) {
  for (const char* lambda : {"0", "1", "-0.2", "1.5"})
    expect_wet_fault("lambda = 0.27", "lambda = @@" + std::string(lambda), "it must be above 0 and below 1");
  expect_fault(
      change(change(wet_slope, "lambda = 0.27\n", ""), "[materials.sand.water]", "@@[materials.sand.water]"),
      "missing key 'lambda' in [materials.sand.water], for example lambda = 0.27; retention = \"van_genuchten\" "
      "needs it");
}

TEST(Mualem, NeedsLambdaWithAnotherCurveToo) {
  const std::string linear = change(change(change(wet_slope, "retention = \"van_genuchten\"", "retention = \"linear\""),
                                           "reference_pressure = 6.13", "dry_suction = 100"),
                                    "lambda = 0.27", "relative_conductivity = \"mualem\"");
  expect_fault(change(linear, "[materials.sand.water]", "@@[materials.sand.water]"),
               "missing key 'lambda' in [materials.sand.water], for example lambda = 0.27; relative_conductivity = "
               "\"mualem\" needs it");
  expect_fault(change(linear, "\"mualem\"", "\"constant\"\nlambda = @@0.3"),
               "has a meaning only with retention = \"van_genuchten\" or relative_conductivity = \"mualem\"");
}

TEST(WetSoil, NeedsEitherConductivityOrPermeability) {
  expect_fault(
      change(change(wet_slope, "permeability = 6e-11\n", ""), "[materials.sand.water]", "@@[materials.sand.water]"),
      "material 'sand' has pore water; give its 'conductivity', for example 1e-5 (m/s), or its 'permeability'");
  expect_wet_fault("permeability = 6e-11", "conductivity = 1e-5\npermeability = @@6e-11",
                   "both a conductivity and a permeability");
  expect_wet_fault("permeability = 6e-11", "conductivity = @@0", "above 0 m/s");
  expect_wet_fault("permeability = 6e-11", "conductivity = @@\"6e-11 m2\"", "'6e-11 m2' is an area");
}

TEST(WetSoil, NeedsPores) {
  expect_wet_fault("porosity = 0.2", "porosity = @@0", "'porosity' is 0; material 'sand' has pore water");
  expect_wet_fault("porosity = 0.2", "porosity = @@1", "below 1");
  EXPECT_TRUE(find_faults(change(slope, "porosity = 0.2", "porosity = 0")).empty()) << "dry soil may do without";
}

TEST(DrySoil, HasNoKeysOfWater) {
  expect_fault(slope + "[materials.sand.water]\nconductivity = @@1e-5\n",
               "has a meaning only with retention other than \"dry\"");
}

TEST(RetentionTable, FallsWithSuction) {
  const auto table = [](const std::string& rows) {
    return change(wet_slope,
                  "retention = \"van_genuchten\"\nminimum_saturation = 0.15\nreference_pressure = 6.13\nlambda = 0.27",
                  "retention = \"table\"\nretention_table = " + rows);
  };
  EXPECT_TRUE(find_faults(table("[[0, 1], [10, 0.5]]")).empty());
  expect_fault(table("@@[[0, 0.5], [10, 1]]"), "'retention_table' is no falling curve");
  expect_fault(table("@@[[0, 1], [10, 0.5], [\"20 kPa\", 0.6]]"), "must only fall or only rise, but turns at 10.");
  expect_fault(table("@@[[0, 1], [20, 0.5], [10, 0.4]]"), "must have increasing suctions, but 10 comes after 20.");
  expect_fault(table("@@[[0, 1]]"), "has 1 points; 2 to 48 are needed");
  expect_fault(table("@@[[0, 1], [10, 1]]"), "the same everywhere");
  expect_fault(table("[[0, 1], [10, @@1.5]]"), "at least 0 and at most 1");
  expect_fault(table("[[0, 1], [@@\"10 m\", 0.5]]"), "'10 m' is a length");
  expect_fault(table("[[0, 1], [@@-10, 0.5]]"), "at least 0 kPa");
  expect_fault(table("@@3"), "must be rows [suction, value]");
  expect_fault(table("[[0, 1], @@[10]]"), "must be rows [suction, value], not a list of 1");
}

TEST(ConductivityTable, FallsWithSuctionAndStaysAboveZero) {
  const auto table = [](const std::string& rows) {
    return change(wet_slope, "lambda = 0.27",
                  "lambda = 0.27\nrelative_conductivity = \"table\"\nconductivity_table = " + rows);
  };
  EXPECT_TRUE(find_faults(table("[[0, 1], [10, 0.5]]")).empty());
  expect_fault(table("@@[[0, 0.1], [10, 0.5]]"), "'conductivity_table' is no falling curve");
  expect_fault(table("@@[[0, 1], [10, 0]]"), "above 0 and up to 1, not 0");
}

TEST(Chi, OfKhaliliAndKhabbazNeedsAnAirEntry) {
  expect_fault(change(change(wet_slope, "lambda = 0.27", "lambda = 0.27\nchi = \"khalili_khabbaz\""),
                      "[materials.sand.water]", "@@[materials.sand.water]"),
               "missing key 'chi_air_entry'");
}

TEST(BulkModulus, IsFiniteWhereTheCurveIsFlat) {
  for (const char* modulus : {"inf", "1e12"})
    expect_wet_fault("bulk_modulus = 80000", "bulk_modulus = @@" + std::string(modulus),
                     "the retention curve of material 'sand' is flat at saturation");
  expect_wet_fault("bulk_modulus = 80000", "bulk_modulus = @@-1", "above 0 kPa");
  expect_wet_fault("bulk_modulus = 80000", "bulk_modulus = @@nan", "must be a finite number");
}

TEST(TotalHead, IsNotBelowTheSoil) {
  expect_wet_fault("head = 10", "head = @@-0.5", "'head' is -0.5 m, below the lowest point of the soil, 0 m");
  expect_wet_fault("head = 10", "head = @@[[0, 10], [5, \"-10 cm\"]]", "'head' is -0.1 m");
}

TEST(Hydraulic, APoolAboveTheCrestIsReported) {
  const auto find_warnings_for = [](const std::string& head) {
    return read_case_text(change(wet_slope, "head = 5", head), "slope.toml").warnings;
  };
  EXPECT_TRUE(find_warnings_for("head = 14").empty());
  const auto warnings = find_warnings_for("head = [[0, 5], [10, 16]]");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].sentence.find("the pool on 'toe' stands up to 16 m, above the crest, 15 m"), std::string::npos)
      << warnings[0].sentence;
}

TEST(Hydraulic, NeedsASideOrLineThatExists) {
  expect_wet_fault("on = \"slope\"", "on = @@\"slop\"", "there is no side or line 'slop'; did you mean 'slope'?");
  expect_wet_fault("on = \"slope\"", "on = @@\"crest\"", "there are two hydraulic conditions on 'crest'");
}

TEST(Rain, FallsOnASurface) {
  const auto rain_on = [](const std::string& name) {
    return change(wet_slope, crest, "on = @@\"" + name + "\"\ncondition = \"rain\"\nrate = 10");
  };
  expect_fault(rain_on("drain"), "rain on 'drain', which is never a surface of the soil: it lies inside the soil");
  expect_fault(rain_on("right"), "rain on 'right', which is never a surface of the soil: draw a line along the ground");
  expect_fault(rain_on("bottom"), "never a surface");
  expect_fault(rain_on("top"), "the soil does not reach it");
  EXPECT_TRUE(find_faults(take_mark(rain_on("crest")).text).empty());
  const std::string level = change(take_mark(rain_on("top")).text, "[44, 17]]", "[44, 15]]");
  EXPECT_TRUE(find_faults(level).empty()) << "the crest is the top of this box";
}

TEST(SeepageFace, LiesOnASurface) {
  expect_wet_fault(crest, "on = @@\"drain\"\ncondition = \"seepage_face\"",
                   "a seepage face on 'drain', which is never");
  EXPECT_TRUE(find_faults(change(wet_slope, crest, "on = \"right\"\ncondition = \"seepage_face\"")).empty());
  // The lower half of the line is in the soil, the upper half on its surface.
  const std::string half = change(wet_slope, "points = [[10, 2], [20, 2]]", "points = [[2, 5], [2, 15], [9, 15]]");
  EXPECT_TRUE(find_faults(change(half, crest, "on = \"drain\"\ncondition = \"seepage_face\"")).empty());
  const std::string wall = change(wet_slope, "points = [[10, 2], [20, 2]]", "points = [[0, 2], [0, 9]]");
  expect_fault(change(wall, crest, "on = @@\"drain\"\ncondition = \"seepage_face\""), "along a side of the box");
  const std::string air = change(wet_slope, "points = [[10, 2], [20, 2]]", "points = [[20, 12], [30, 12]]");
  expect_fault(change(air, crest, "on = @@\"drain\"\ncondition = \"seepage_face\""), "no soil touches it");
}

TEST(Rain, FallsOnALineAlongLevelGroundWithoutMpm) {
  const std::string column = R"(title = "column"
analysis.methods = ["seepage"]
geometry.polygon = [{ name = "c", points = [[0, 0], [2, 0], [2, 5], [0, 5]] }]
geometry.line = [{ name = "ground", points = [[0, 5], [2, 5]] }, { name = "end", points = [[2, 0], [2, 5]] }]
regions.c = "s"
mesh.size = 0.5
hydraulic = [{ on = "ground", condition = "rain", rate = 1 }, { on = "end", condition = "seepage_face" }]
materials.s = { porosity = 0.4, water = { retention = "saturated", conductivity = 1e-6 } }
)";
  EXPECT_TRUE(find_faults(column).empty());
  const std::string aside = change(column, "[[0, 5], [2, 5]]", "[[0, 0], [0, 5]]");
  const std::vector<Diagnostic> faults = find_faults(aside);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].sentence.find("rain on 'ground', which is never a surface of the soil"), std::string::npos);
}

TEST(Hydraulic, LiesOnASurfaceOfSoilWithWater) {
  // A run refuses these as without effect.
  for (const char* condition : {"\"total_head\"\nhead = 10", "\"flux\"\nrate = -1", "\"pressure\"\npressure = 1"}) {
    expect_fault(change(wet_slope, crest, "on = @@\"drain\"\ncondition = " + std::string(condition)),
                 "on 'drain', which is never a surface of the soil: soil with pore water lies on both");
    EXPECT_TRUE(find_faults(change(wet_slope, crest, "on = \"crest\"\ncondition = " + std::string(condition))).empty());
  }
  EXPECT_TRUE(find_faults(change(wet_slope, crest, "on = \"drain\"\ncondition = \"no_flow\"")).empty());
}

TEST(Hydraulic, FreeDrainageIsNotOfMpmNorOfSidesThatFaceUp) {
  expect_wet_fault("on = \"left\"\ncondition = \"total_head\"\nhead = 10",
                   "on = \"bottom\"\ncondition = @@\"free_drainage\"", "MPM has none");
  const std::string alone =
      "analysis.methods = [\"seepage\"]\nmesh.size = 1\nregions.soil = \"sand\"\n"
      "geometry.polygon = [{ name = \"soil\", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]\n"
      "materials.sand = { porosity = 0.4, water = { retention = \"saturated\", conductivity = 1e-4 } }\n"
      "hydraulic = [{ on = \"top\", condition = \"total_head\", head = 2 }, { on = \"bottom\", condition = "
      "\"free_drainage\" }]\n";
  EXPECT_TRUE(find_faults(alone).empty());
  expect_fault(change(alone, "on = \"bottom\"", "on = @@\"left\""), "it drains through sides that face down");
}

TEST(Conductivity, IsOneInMpm) {
  expect_wet_fault("permeability = 6e-11", "permeability = 6e-11\nconductivity_ratio = @@0.1", "MPM has one");
}

TEST(Hydraulic, HasTheKeysOfItsCondition) {
  expect_wet_fault("condition = \"total_head\"\nhead = 10", "condition = \"total_head\"\nhead = 10\nrate = @@3",
                   "has a meaning only with condition = \"rain\" or \"flux\"");
  expect_fault(change(wet_slope, "[[hydraulic]]\n" + crest, "@@[[hydraulic]]\non = \"crest\"\ncondition = \"rain\""),
               "missing key 'rate' in [[hydraulic]]");
  expect_wet_fault(crest, "on = \"crest\"\ncondition = @@\"seepage\"",
                   "choose one of total_head, pressure, seepage_face");
  expect_wet_fault(crest, "on = \"crest\"\ncondition = \"rain\"\nrate = @@\"10 mm\"", "'10 mm' is a length");
}

TEST(Series, HasIncreasingTimes) {
  const auto rate = [](const std::string& rows) {
    return change(wet_slope, crest, "on = \"crest\"\ncondition = \"rain\"\nrate = " + rows);
  };
  expect_fault(rate("[[0, 1], [10, 2], @@[5, 3]]"), "the times of 'rate' must not decrease from row to row");
  expect_fault(rate("[[0, 1], [0, 2], @@[0, 3]]"), "three rows at one time");
  expect_fault(rate("@@[[0, 1], [5, 2], [5, 3]]\nseries = \"steps\""), "must increase from row to row where series");
  expect_fault(
      rate("[[0, 1], @@[5, 2, 3]]"),
      "must be a value, rows [time, value], or { file = \"station.csv\", column = \"rain\" }, not a list of 3");
  expect_fault(rate("[[0, 1], [@@\"5 m\", 2]]"), "'5 m' is a length");
  expect_fault(rate("@@[]"), "must be a value, rows [time, value]");
  expect_fault(rate("@@true"), "'rate' must be a speed");
}

TEST(Hydraulic, NeedsAWetMaterial) {
  expect_fault(slope + "@@[[hydraulic]]\non = \"crest\"\ncondition = \"seepage_face\"\n",
               "[[hydraulic]] has no meaning: no material has pore water");
}

TEST(Start, NeedsAWetMaterial) {
  expect_fault(slope + "[initial]\npore_pressure = @@\"seepage\"\n", "no material has pore water");
}

TEST(Start, FromAWaterTableNeedsOneFromLeftToRight) {
  expect_fault(change(start("pore_pressure = \"water_table\""), "[initial]", "@@[initial]"),
               "missing key 'water_table' in [initial]");
  expect_fault(start("pore_pressure = \"water_table\"\nwater_table = [[0, 10], @@[0, 5]]"),
               "must run from left to right, x increasing");
  expect_fault(start("pore_pressure = \"water_table\"\nwater_table = @@[]"), "at least one point");
  expect_fault(start("pore_pressure = \"zero\"\nlargest_suction = @@30"), "only with pore_pressure = \"water_table\"");
}

TEST(Start, FromSeepageNeedsALevel) {
  std::string text = change(wet_slope, "condition = \"total_head\"\nhead = 10", "condition = \"no_flow\"");
  text = change(text, "condition = \"total_head\"\nhead = 5", "condition = \"no_flow\"");
  EXPECT_TRUE(find_faults(text).empty()) << "the seepage faces are enough";
  text = change(text, crest, "on = \"crest\"\ncondition = \"no_flow\"");
  text = change(text, "condition = \"seepage_face\"", "condition = \"rain\"\nrate = 1");
  expect_fault(change(text, "pore_pressure = \"seepage\"", "pore_pressure = @@\"seepage\""),
               "needs a [[hydraulic]] with condition total_head, pressure, seepage_face or free_drainage");
}

TEST(Levels, NeedGravityThatActsDownwards) {
  expect_fault(wet_slope + "[gravity]\ndirection = @@[1, -2]\n", "levels along y: gravity needs the direction [0, -1]");
  expect_fault(wet_slope + "[gravity]\nacceleration = @@0\n", "needs gravity to drive water");
}

TEST(DrainedWater, NeedsFrozenGeometry) {
  expect_wet_fault("conductivity_factor = 2", "water = @@\"held\"", "water = \"held\" needs geometry = \"frozen\"");
  expect_fault(wet_slope + "[strength_reduction.frozen]\ngeometry = @@\"moving\"\n", "needs geometry = \"frozen\"");
}

TEST(StepKeysOfWater, HaveNoMeaningInADryCase) {
  expect_fault("damping = 0.7", "conductivity_factor = @@10", "no material has pore water");
  EXPECT_TRUE(find_faults(change(slope, "damping = 0.7", "conductivity_factor = 1\nwater = \"seeps\"")).empty())
      << "a default that is written out does no harm";
  expect_wet_fault("conductivity_factor = 2", "conductivity_factor = @@0", "above 0");
}

TEST(StepKeysOfWater, OfTwoVelocitiesAreRejectedInTheDarcyFormulation) {
  expect_wet_fault("conductivity_factor = 2", "water = \"seeps\"\nwater_damping = @@0.7",
                   "'water_damping' has no meaning with water = \"seeps\": water has no velocity of its own there. It "
                   "needs water = \"flows\"");
  expect_wet_fault("conductivity_factor = 2", "drag = @@\"explicit\"",
                   "'drag' has no meaning with water = \"seeps\", the default: ");
  EXPECT_TRUE(find_faults(wet_slope).empty());
  EXPECT_TRUE(
      find_faults(change(wet_slope, "conductivity_factor = 2", "water = \"flows\"\nwater_damping = 0.7")).empty());
}

TEST(Faults, OfWaterComeTogether) {
  std::string text = change(wet_slope, "lambda = 0.27", "lambda = 2");
  text = change(text, "head = 10", "head = -1");
  text = change(text, "porosity = 0.2", "porosity = 0");
  text = change(text, "on = \"slope\"", "on = \"drain\"");
  EXPECT_EQ(find_faults(text).size(), 4u) << InputError(find_faults(text)).what();
}

}  // namespace
}  // namespace talus::input
