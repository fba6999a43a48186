// SPDX-License-Identifier: MIT
// [[construction]] and [[vertical_drains]]: what is there in a stage, μ of drains, and faults with their places.

#include <cmath>

#include "slope.hpp"

namespace talus::input {
namespace {

/// Clay with a lift and a cut, a road on it, and drains.
const char* const section = R"(
title = "Lift"
[[geometry.polygon]]
name = "clay"
points = [[0, 0], [40, 0], [40, 8], [0, 8]]
[[geometry.polygon]]
name = "lift"
points = [[0, 8], [16, 8], [12, 10], [0, 10]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 5
friction_angle = 24
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "4 MPa"
poisson_ratio = 0.3
[materials.clay.water]
retention = "saturated"
conductivity = "1e-9 m/s"
[materials.fill]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 3
friction_angle = 33
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "20 MPa"
poisson_ratio = 0.3
[regions]
clay = "clay"
lift = "fill"
[initial]
pore_pressure = "water_table"
water_table = [[0, 8], [40, 8]]
[[surcharge]]
name = "road"
x = [2, 8]
load = [10, 10]
[analysis]
methods = ["lem", "fem"]
[fem]
size = 2
[[vertical_drains]]
name = "wicks"
regions = ["clay"]
spacing = 1.5
diameter = 0.0656
head = 8
)";

std::string write_stages(const std::string& stages) {
  return section + stages;
}

const char* const two_stages = R"(
[[construction]]
name = "place"
duration = 20
add = ["lift", "wicks"]
[[construction]]
name = "open"
duration = 30
add = ["road"]
)";

TEST(Construction, ObjectsAreThereFromTheStageThatAddsThem) {
  const Case data = read_case_text(write_stages(two_stages), "lift.toml").data;
  ASSERT_EQ(data.construction.size(), 2u);
  EXPECT_EQ(data.construction[0].duration, 20 * 86400.0);
  EXPECT_TRUE(is_there_at_start(data, "clay"));
  EXPECT_FALSE(is_there_at_start(data, "lift"));
  EXPECT_TRUE(is_there(data, "lift", 0));
  EXPECT_FALSE(is_there(data, "road", 0));
  EXPECT_TRUE(is_there(data, "road", 1));
  EXPECT_TRUE(is_there(data, "clay", 1));
}

TEST(Construction, DrainsHaveTheFactorOfBarronAndHansbo) {
  // n = 1.05·1.5/0.0656 = 24.009; without smear Barron's F = n² ln n/(n² − 1) − (3n² − 1)/(4n²). With smear s = 3 and
  // k_h/k_s = 2, for large n, ln(n/s) + 2 ln s − 3/4.
  VerticalDrains drains;
  drains.spacing = 1.5, drains.diameter = 0.0656;
  const double n = 1.05 * 1.5 / 0.0656, nn = n * n;
  EXPECT_NEAR(find_drain_factor(drains), nn * std::log(n) / (nn - 1) - (3 * nn - 1) / (4 * nn), 1e-12);
  drains.smear = 3, drains.smear_conductivity = 2;
  EXPECT_NEAR(find_drain_factor(drains), std::log(n / 3) + 2 * std::log(3.0) - 0.75, 0.02);
  drains.pattern = DrainPattern::square;
  EXPECT_DOUBLE_EQ(find_served_diameter(drains), 1.13 * 1.5);
}

TEST(Construction, FaultsHaveTheirPlace) {
  const auto stage = [](const std::string& keys) {
    return write_stages("[[construction]]\nname = \"one\"\nduration = 1\n" + keys);
  };
  expect_fault(stage("add = [@@\"lft\"]\n"), "there is no region, surcharge, support or drain 'lft'");
  expect_fault(
      write_stages("[[construction]]\nname = \"one\"\nduration = 1\nadd = [\"lift\"]\n[[construction]]\nname = "
                   "\"two\"\nduration = 1\nadd = [@@\"lift\"]\n"),
      "'lift' is there already when stage 'two' adds it");
  expect_fault(stage("remove = [\"road\", @@\"road\"]\n"), "'road' is not there when stage 'one' removes it");
  expect_fault(stage("remove = @@[\"clay\", \"lift\"]\n"), "stage 'one' leaves no soil");
  expect_fault(write_stages("[[construction]]\nname = \"one\"\nduration = @@-1\n"), "must be");
  expect_fault(write_stages("[[construction]]\nname = \"one\"\nduration = 1\n[[construction]]\nname = "
                            "@@\"one\"\nduration = 1\n"),
               "two stages named 'one'");
  const auto faults = find_faults(change(stage(""), "methods = [\"lem\", \"fem\"]", "methods = [\"lem\"]"));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].sentence.find("stages of construction are computed by FEM"), std::string::npos);
}

TEST(Construction, RegionsInsideOthersCannotGo) {
  const std::string text =
      change(write_stages("[[construction]]\nname = \"one\"\nduration = 1\nremove = [@@\"lift\"]\n"),
             "points = [[0, 8], [16, 8], [12, 10], [0, 10]]", "points = [[4, 2], [16, 2], [12, 6], [4, 6]]");
  expect_fault(text, "region 'lift' lies inside 'clay', which would fill its place");
}

TEST(Construction, DrainsThatDoNotFitAreFaults) {
  const std::string text = write_stages(two_stages);
  expect_fault(change(text, "diameter = 0.0656", "smear = 30\ndiameter = @@0.0656"), "does not fit into");
  expect_fault(change(text, "regions = [\"clay\"]", "regions = [@@\"lift\"]"), "has no pore water");
  expect_fault(change(text, "regions = [\"clay\"]", "regions = [@@\"peat\"]"), "there is no region 'peat'");
}

/// The section with a second clay, a strong fill and a stage that changes soils.
std::string write_soils(const std::string& soils, const std::string& more = "") {
  const std::string others = R"([materials.stiff]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 20
friction_angle = 24
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "8 MPa"
poisson_ratio = 0.3
[materials.stiff.water]
retention = "saturated"
conductivity = "1e-9 m/s"
[regions]
)";
  return change(section, "[regions]\n", others) + "[[construction]]\nname = \"one\"\nduration = 1\n" + more +
         "soils = { " + soils + " }\n";
}

TEST(Construction, SoilsChangeFromAStageOn) {
  const Case data = read_case_text(write_soils("clay = \"stiff\"") + two_stages, "soils.toml").data;
  EXPECT_EQ(data.regions.at("clay"), "clay");
  EXPECT_EQ(data.construction[0].soils.at("clay"), "stiff");
  expect_fault(write_soils("peat = @@\"stiff\""), "there is no region 'peat'");
  expect_fault(write_soils("clay = @@\"peat\""), "there is no material 'peat'");
  expect_fault(write_soils("clay = @@\"fill\""), "'clay' and 'fill' must both have [materials.NAME.water] or neither");
  expect_fault(write_soils("lift = @@\"stiff\"") + "[[construction]]\nname = \"two\"\nduration = 1\nadd = [\"lift\"]\n",
               "region 'lift' is not there in stage 'one'");
  // Soil that a stage places may have water or not.
  EXPECT_NO_THROW(read_case_text(write_soils("lift = \"stiff\"", "add = [\"lift\"]\n"), "soils.toml"));
}

TEST(Construction, MpmNeedsAStageThatReleasesIt) {
  const std::string stage = "[[construction]]\nname = \"one\"\nduration = 1\n";
  const auto find = [](const std::string& text) {
    std::string all;
    for (const Diagnostic& fault : find_faults(text)) all += fault.sentence + "\n";
    return all;
  };
  const std::string with_mpm = change(section, "methods = [\"lem\", \"fem\"]", "methods = [\"fem\", \"mpm\"]");
  EXPECT_NE(find(with_mpm + stage).find("give one of [[construction]] release = true"), std::string::npos);
  expect_fault(write_stages(stage + "release = @@true\n"), "add \"mpm\" to [analysis] methods");
}

TEST(Construction, MeasurementsNeedStages) {
  const std::string monitor = "[[output.monitor]]\nname = \"plate\"\nat = [2, 8]\nmeasured_settlement = ";
  const Case data =
      read_case_text(write_stages(two_stages) + monitor + "[[\"0 day\", 0], [\"10 day\", 25]]\n", "lift.toml").data;
  ASSERT_EQ(data.output.monitors.size(), 1u);
  EXPECT_EQ(data.output.monitors[0].settlement.time, (std::vector<double>{0, 10 * 86400.0}));
  EXPECT_NEAR(data.output.monitors[0].settlement.value[1], 0.025, 1e-15);
  EXPECT_TRUE(data.output.monitors[0].pressure.time.empty());
  const std::string without = change(section,
                                     "[[vertical_drains]]\nname = \"wicks\"\nregions = [\"clay\"]\nspacing = 1.5\n"
                                     "diameter = 0.0656\nhead = 8\n",
                                     "");
  expect_fault(without + change(monitor, "measured_settlement = ", "measured_settlement = @@") + "[[0, 0]]\n",
               "measurements are compared with the stages of [[construction]]");
}

}  // namespace
}  // namespace talus::input
