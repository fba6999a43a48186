// SPDX-License-Identifier: MIT
// [analysis] methods: the keys that LEM, FEM and MPM require, and those that they exclude.

#include <nlohmann/json.hpp>

#include "methods_slope.hpp"

#include "input/case/result_names.hpp"

namespace talus::input {
namespace {

TEST(Methods, SlicesAloneNeedGeometryWeightAndStrength) {
  const Case data = read(slices_alone);
  EXPECT_EQ(data.methods, std::vector<Method>{Method::lem});
  EXPECT_TRUE(uses(data, Method::lem));
  EXPECT_FALSE(uses(data, Method::mpm));
  EXPECT_DOUBLE_EQ(data.materials.at("soil").slices.unit_weight.value(), 20e3);
  EXPECT_EQ(data.mesh.box_min, (std::array{0.0, 20.0})) << "the bounding box of the soil";
  EXPECT_EQ(data.mesh.box_max, (std::array{90.0, 35.0}));
  EXPECT_TRUE(data.stages.empty());
}

TEST(Methods, MaterialPointsAnswerWhereNobodyIsNamed) {
  EXPECT_EQ(read(slope).methods, std::vector<Method>{Method::mpm});
}

TEST(Methods, KeysThatAMethodNeedsAreRequired) {
  // FEM needs stiffness, flow and element size of the same file, and MPM needs more.
  const auto list = [](const std::string& methods) {
    std::string all;
    for (const Diagnostic& fault : find_faults(change(slices_alone, "[\"lem\"]", methods)))
      all += fault.sentence + "\n";
    return all;
  };
  const std::string elements = list("[\"lem\", \"fem\"]"), points = list("[\"mpm\"]");
  const std::string soil = "missing keys 'young_modulus', 'poisson_ratio', 'dilatancy_angle' and 'tensile_strength' in";
  EXPECT_NE(elements.find(soil), std::string::npos) << elements;
  EXPECT_NE(points.find("'young_modulus', 'poisson_ratio', 'dilatancy_angle' and 'tensile_strength' in"),
            std::string::npos)
      << points;
  EXPECT_NE(elements.find("FEM needs a size"), std::string::npos) << elements;
  EXPECT_EQ(elements.find("'box'"), std::string::npos) << elements;
  EXPECT_EQ(elements.find("no stage"), std::string::npos) << elements;
  for (const char* part : {"missing key 'box'", "missing key 'size' in [mesh]", "there is no stage"})
    EXPECT_NE(points.find(part), std::string::npos) << points;
}

TEST(Methods, WhatNobodyNeedsMayBeGiven) {
  const std::string whole = change(slope, "grain_density = 2500\nporosity = 0.2", "unit_weight = 20");
  for (const char* methods : {"[\"lem\"]", "[\"fem\"]", "[\"mpm\"]", "[\"mpm\", \"lem\", \"fem\"]"})
    EXPECT_TRUE(find_faults(whole, {{"analysis.methods", methods}}).empty()) << methods;
}

TEST(Methods, FemHasDefaultSupports) {
  const Case data = read(with_elements);
  ASSERT_EQ(data.boundaries.size(), 3u);
  EXPECT_EQ(data.boundaries[0].on, "bottom");
  EXPECT_EQ(data.boundaries[0].fix, Fix::full);
  EXPECT_EQ(data.boundaries[1].fix, Fix::normal);
  EXPECT_DOUBLE_EQ(data.mesh.size, 1.5) << "that of [fem], where [mesh] has none";
  EXPECT_TRUE(read(slices_alone).boundaries.empty());
  const std::string plane = change(with_elements, "[\"lem\", \"fem\"]", "[\"fem\"]");
  const std::string thick =
      change(plane, "[[geometry.polygon]]", "[geometry]\ndimension = 3\nthickness = 2\n[[geometry.polygon]]");
  EXPECT_EQ(read(thick).boundaries.size(), 5u) << "front and back as well";
  EXPECT_EQ(read(plane).fem.meshes, 2);
  EXPECT_EQ(read(thick).fem.meshes, 1) << "a second mesh of tetrahedra is left to the case";
  EXPECT_EQ(read(change(thick, "[fem]\n", "[fem]\nmeshes = 2\n")).fem.meshes, 2);
  const std::string held = with_elements + "[[boundary]]\non = \"bottom\"\nfix = \"normal\"\n";
  ASSERT_EQ(read(held).boundaries.size(), 1u) << "a boundary of the case's own";
  std::string free = all_three;
  for (const char* block :
       {"[[boundary]]\non = \"bottom\"\nfix = \"full\"\n\n", "[[boundary]]\non = \"left\"\nfix = \"normal\"\n\n"})
    free = change(free, block, "");
  expect_one_fault(free, "there is no [[boundary]]");
}

TEST(Methods, FiniteElementsTakeNoWallsThatRubOrMove) {
  const std::string wall = "[[boundary]]\non = \"left\"\nfix = ";
  expect_fault(with_elements + wall + "@@\"friction\"\nfriction = 0.3\n",
               "a wall with friction is not possible with FEM");
  expect_fault(with_elements + wall + "@@\"velocity\"\nvelocity = [0.1, 0]\n",
               "a boundary that moves is not possible with FEM");
}

TEST(Methods, BoundsNeedTensionAndTakeNoWallsThatRub) {
  const std::string bounds = change(slices_alone, "[\"lem\"]", "[\"bounds\"]");
  expect_one_fault(bounds, "tensile_strength");
  const std::string whole = change(bounds, "friction_angle = 19.6\n", "friction_angle = 19.6\ntensile_strength = 0\n");
  EXPECT_EQ(read(whole).boundaries.size(), 3u) << "fixed as for FEM";
  EXPECT_DOUBLE_EQ(read(whole).bounds.gap, 0.01);
  const std::string wall = "[[boundary]]\non = \"left\"\nfix = ";
  expect_fault(whole + wall + "@@\"friction\"\nfriction = 0.3\n",
               "a wall with friction is not possible with limit analysis");
  // One sentence for both methods.
  const std::string both = change(with_elements, "[\"lem\", \"fem\"]", "[\"fem\", \"bounds\"]");
  expect_fault(both + wall + "@@\"friction\"\nfriction = 0.3\n",
               "a wall with friction is not possible with FEM and limit analysis; take \"fem\" and \"bounds\" out");
  expect_fault(whole + "[bounds]\ngap = @@2\n", "gap");
  expect_fault(change(all_three, "[\"lem\", \"fem\", \"mpm\"]", "[\"bounds\"]") + "[bounds]\ntriangles = @@0\n",
               "triangles");
}

TEST(Methods, AreNamedOnceAndAtLeastOne) {
  expect_fault(change(slices_alone, "[\"lem\"]", "@@[]"), "'methods' is empty; name at least one");
  expect_fault(change(slices_alone, "[\"lem\"]", "[\"lem\", @@\"lem\"]"), "names \"lem\" twice");
  expect_fault(change(slices_alone, "[\"lem\"]", "[\"lem\", @@\"fme\"]"), "did you mean 'fem'?");
}

TEST(Methods, SlicesArePlaneAndNeedPolygons) {
  expect_one_fault(change(all_three, "dimension = 2", "dimension = 3\nthickness = 5"), "LEM analyses a plane section");
  const std::string clay = change(slices_alone, "model = \"mohr_coulomb\"", "model = \"modified_cam_clay\"");
  const std::string clay_keys =
      "lambda = 0.1\nkappa = 0.02\ncritical_state_slope = 1\npreconsolidation = 100\nporosity = 0.4\n";
  expect_one_fault(change(clay, "cohesion = 3\nfriction_angle = 19.6\n", clay_keys),
                   "material 'soil' has no cohesion and friction angle for LEM");
  expect_one_fault(slices_alone + "[gravity]\ndirection = [0.1, -1]\n", "LEM needs gravity along y");
  expect_one_fault(slices_alone + "[gravity]\nacceleration = 0\n", "needs a weight");
}

TEST(Methods, RockIsNoFaultButMustNotBeAll) {
  const std::string rock =
      "[materials.rock]\nmodel = \"linear_elastic\"\nunit_weight = 26\n[[geometry.polygon]]\nname = \"rock\"\n"
      "points = [[0, 10], [90, 10], [90, 20], [0, 20]]\n";
  EXPECT_TRUE(
      find_faults(change(slices_alone, "soil = \"soil\"\n", "soil = \"soil\"\nrock = \"rock\"\n") + rock).empty());
  expect_one_fault(
      change(change(slices_alone, "cohesion = 3\nfriction_angle = 19.6\n", ""), "mohr_coulomb", "linear_elastic"),
      "a factor of safety needs a material with a strength");
}

TEST(Methods, OneInputServesAllMethods) {
  EXPECT_TRUE(find_faults(all_three).empty());
  const std::string load = "[[surcharge]]\nname = \"road\"\nx = [2, 8]\nload = [20, 20]\n";
  EXPECT_TRUE(find_faults(all_three + load).empty());
  EXPECT_TRUE(find_faults(all_three + "[earthquake]\nhorizontal = 0.1\n").empty());
  EXPECT_TRUE(find_faults(change(all_three, "cohesion = 2\n", "cohesion = 2\npore_pressure_ratio = 0.2\n")).empty());
  EXPECT_TRUE(
      find_faults(change(all_three, "cohesion = 2\n", "cohesion = 2\ncohesion_gradient = 2\ncohesion_level = 10\n"))
          .empty());
  const std::string extra = load + "[earthquake]\nhorizontal = 0.1\nvertical = -0.05\n";
  EXPECT_TRUE(
      find_faults(change(with_elements, "cohesion = 3\n",
                         "cohesion = 3\npore_pressure_ratio = 0.2\ncohesion_gradient = 2\ncohesion_level = 30\n") +
                  extra)
          .empty());
}

TEST(Methods, WaterTablesActInAnySoilOfSlicesAndElements) {
  const std::string line = "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 25], [90, 30]]\n";
  EXPECT_TRUE(find_faults(slices_alone + line).empty());
  EXPECT_TRUE(find_faults(with_elements + line).empty());
  EXPECT_TRUE(find_faults(all_three + line).empty());
  expect_one_fault(slices_alone + change(line, "[0, 25], [90, 30]", "[0, 25], [0, 30]"), "x increasing");
  expect_one_fault(slices_alone + "[initial]\npore_pressure = \"seepage\"\n", "no material has pore water");
}

TEST(Methods, SeepageNeedsAMeshEvenForLem) {
  const std::string wet = change(slices_alone, "unit_weight = 20\n", "grain_density = 2650\nporosity = 0.4\n") +
                          "[materials.soil.water]\nretention = \"saturated\"\nconductivity = 1e-5\n"
                          "[initial]\npore_pressure = \"seepage\"\n[[hydraulic]]\non = \"left\"\n"
                          "condition = \"total_head\"\nhead = 25\n";
  expect_one_fault(wet, "follow from seepage need a mesh");
  EXPECT_TRUE(find_faults(wet + "[mesh]\nsize = 1\n").empty());
}

TEST(UnitWeight, ReplacesGrainsAndPores) {
  const std::string heavy = change(slope, "grain_density = 2500\nporosity = 0.2", "unit_weight = 19.62");
  const Material sand = read(heavy).materials.at("sand");
  EXPECT_NEAR(sand.density(), 2000, 1e-9) << "γ/g is the density of the dry soil";
  const Material porous =
      read(change(heavy, "unit_weight = 19.62", "unit_weight = 19.62\nporosity = 0.2")).materials.at("sand");
  EXPECT_NEAR(porous.grain_density, 2500, 1e-9);
  EXPECT_NEAR(porous.density(), 2000, 1e-9);
}

TEST(UnitWeight, IsGivenOnceAndNotAloneForMovingWater) {
  expect_fault(change(slope, "grain_density = 2500", "unit_weight = 20\ngrain_density = @@2500"),
               "both a unit weight and a grain density");
  const std::string water = "[materials.soil.water]\nretention = \"saturated\"\nconductivity = 1e-5\n";
  // LEM takes the weight as given; only the water in the pores must be known.
  EXPECT_TRUE(
      find_faults(change(slices_alone, "unit_weight = 20\n", "unit_weight = 20\nporosity = 0.4\n") + water).empty());
  expect_one_fault(slices_alone + water, "needs pores: a porosity above 0 and below 1");
  expect_fault(change(slope, "grain_density = 2500", "unit_weight = @@20") +
                   "[materials.sand.water]\nretention = \"saturated\"\nconductivity = 1e-5\n",
               "give 'grain_density' and 'porosity' as well");
  EXPECT_TRUE(find_faults(change(slices_alone, "unit_weight = 20\n",
                                 "unit_weight = 20\ngrain_density = 2650\nporosity = 0.4\n") +
                          water)
                  .empty());
  expect_fault(change(slices_alone, "unit_weight = 20\n", "unit_weight = 20\nsaturated_unit_weight = @@19\n"),
               "must not be smaller than the unit weight, 20 kN/m3");
}

TEST(SuctionStrength, NeedsWhatItFollowsFrom) {
  const auto with = [](const std::string& keys) {
    return change(slices_alone, "cohesion = 3\n", "cohesion = 3\n" + keys);
  };
  expect_fault(with("suction_strength = @@\"saturation\"\n"), "needs the retention curve of material 'soil'");
  expect_fault(with("phi_b = @@15\n"), "has a meaning only with suction_strength = \"phi_b\"");
  expect_fault(with("suction_strength = \"phi_b\"\nphi_b = @@25\n"), "greater than its friction angle");
  EXPECT_TRUE(find_faults(with("suction_strength = \"phi_b\"\nphi_b = 15\n")).empty());
  expect_one_fault(with("suction_strength = \"phi_b\"\n"), "missing key 'phi_b'");
}

TEST(CohesionGradient, HasALevelAndStaysPositive) {
  const auto with = [](const std::string& keys) {
    return change(slices_alone, "cohesion = 3\n", "cohesion = 3\n" + keys);
  };
  expect_fault(with("cohesion_gradient = @@2\n"), "belong together");
  // 3 kPa - 0.5 kPa/m · (30 m - 20 m)
  expect_fault(with("cohesion_gradient = @@-0.5\ncohesion_level = 30\n"), "would be negative, -2 kPa at y = 20 m");
  EXPECT_TRUE(find_faults(with("cohesion_gradient = -0.2\ncohesion_level = 30\n")).empty());
  expect_fault(with("pore_pressure_ratio = @@1\n"), "at least 0 and below 1");
}

TEST(Echo, LeavesOutWhatNoMethodNeeds) {
  const nlohmann::json echo = read_case_text(slices_alone, "slope.toml").echo.get();
  for (const char* key : {"young_modulus", "poisson_ratio", "dilatancy_angle"})
    EXPECT_FALSE(echo["materials"]["soil"].contains(key)) << key;
  EXPECT_FALSE(echo["mesh"].contains("size"));
  EXPECT_EQ(echo["materials"]["soil"]["unit_weight"],
            (nlohmann::json{{"value", 20.0}, {"unit", "kN/m3"}, {"given", true}}));
  EXPECT_TRUE(read_case_text(with_elements, "slope.toml").echo.get()["materials"]["soil"].contains("young_modulus"));
}

TEST(Compare, ListsTheResultsOfEachMethod) {
  const std::string compare = "tolerance = \"1 %\"\nvalue = 1\nsource = \"a referee\"\nname = ";
  for (const char* name :
       {"lem.bishop", "lem.noncircular.spencer", "lem.yield_acceleration.morgenstern_price", "fem.factor",
        "fem.associated.by_displacement", "lem.handed[fem.band].spencer", "factor_of_safety"})
    EXPECT_TRUE(find_faults(slices_alone + "[[compare]]\n" + compare + "\"" + name + "\"\n").empty()) << name;
  const std::string surface = "[[lem.surface]]\nname = \"A\"\ncentre = [30, 55]\nradius = 30\n";
  EXPECT_TRUE(find_faults(slices_alone + surface + "[[compare]]\n" + compare + "\"lem.surface[A].janbu\"\n").empty());
  expect_fault(slices_alone + "[[compare]]\n" + compare + "@@\"lem.noncircular.bishop\"\n", "yields no result");
  expect_fault(slices_alone + "[[compare]]\n" + compare + "@@\"lem.bishpo\"\n", "did you mean 'lem.bishop'?");
  std::vector<std::string> names;
  for (const results::NamedValue& result : list_result_names(read(slices_alone))) names.push_back(result.name);
  EXPECT_EQ(names.front(), "main_factor");
  EXPECT_EQ(std::count(names.begin(), names.end(), "lem.bishop"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "mesh.points"), 0) << "there are none";
  EXPECT_EQ(std::count(names.begin(), names.end(), "lem.handed[fem.band].spencer"), 0) << "nobody hands it over";
}

TEST(UnitWeight, IsNoMassWithoutGravity) {
  const std::string still = change(slope, "grain_density = 2500", "unit_weight = @@20");
  expect_fault(still + "[gravity]\nacceleration = 0\n",
               "without gravity the unit weight of material 'sand' gives no mass");
}

}  // namespace
}  // namespace talus::input
