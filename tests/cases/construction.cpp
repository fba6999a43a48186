// SPDX-License-Identifier: MIT
// Stages of construction in a run: excess pressures that rise and fall, factors at the ends of stages with the pore
// pressures and stresses of the stage, excavation without water, and a lift that is too high.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

/// A lift on soft clay over sand, on coarse elements.
const char* const lift = R"(
title = "Lift"
[[geometry.polygon]]
name = "clay"
points = [[0, 0], [30, 0], [30, 6], [0, 6]]
[[geometry.polygon]]
name = "lift"
points = [[0, 6], [14, 6], [10, 8], [0, 8]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 6
friction_angle = 24
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "4 MPa"
poisson_ratio = 0.33
[materials.clay.water]
retention = "saturated"
conductivity = "2e-9 m/s"
[materials.fill]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 4
friction_angle = 33
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "20 MPa"
poisson_ratio = 0.3
[regions]
clay = "clay"
lift = "fill"
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 6], [30, 6]]
[analysis]
methods = ["lem", "fem"]
[fem]
size = 1.5
meshes = 1
[lem]
methods = ["spencer"]
noncircular = false
yield_acceleration = false
minima = 1
referee = false
[lem.entry_exit]
exits = 12
entries = 12
depths = 8
[[output.monitor]]
name = "middle"
at = [2, 3]
[[construction]]
name = "lift"
duration = 10
add = ["lift"]
[[construction]]
name = "rest"
duration = "20 year"
)";

class ConstructionRuns : public MethodsTest {};

TEST_F(ConstructionRuns, FactorsGrowWithConsolidation) {
  const auto summary = run(lift);
  const auto& construction = summary.at("construction");
  const auto& stages = construction.at("stages");
  ASSERT_EQ(stages.size(), 2u);
  for (const auto& stage : stages) {
    EXPECT_TRUE(stage.at("converged"));
    EXPECT_EQ(stage.at("factors").size(), 2u);
    // LEM and FEM at the end of a stage have the same pore pressures.
    const double lem = stage.at("factors")[0].at("factor"), fem = stage.at("factors")[1].at("factor");
    EXPECT_NEAR(fem, lem, 0.05 * lem);
    for (const auto& step : stage.at("steps")) EXPECT_LT(step.at("residual").get<double>(), 1e-6);
  }
  const auto& placed = stages[0].at("steps").back();
  const auto& rested = stages[1].at("steps").back();
  // The clay bears next to nothing of the 2 m of fill at first, and all of it in the end.
  EXPECT_GT(placed.at("excess").get<double>(), 0.8 * 2 * 19e3);
  EXPECT_LT(rested.at("excess").get<double>(), 0.02 * 2 * 19e3);
  EXPECT_GT(rested.at("settlement").get<double>(), 1.5 * placed.at("settlement").get<double>());
  EXPECT_GT(stages[1].at("least").get<double>(), 1.05 * stages[0].at("least").get<double>());
  EXPECT_EQ(construction.at("least"), stages[0].at("least"));
  EXPECT_EQ(summary.at("main_factor"), construction.at("least"));
  // The monitor has a value for each step; in the end its pressure is that of the water table.
  const auto& monitor = construction.at("monitors")[0];
  EXPECT_EQ(monitor.at("pressure").size(), stages[0].at("steps").size() + stages[1].at("steps").size());
  EXPECT_NEAR(monitor.at("pressure").back().get<double>(), 3 * 9810.0, 700);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "stage_1" / "summary.json"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "construction.json"));
}

TEST_F(ConstructionRuns, AStageShowsWhatIsThere) {
  // The lift goes in the second stage: its results have its section alone, and the run repeats their warnings.
  const auto summary = run(
      lift,
      {{"analysis.methods", "[\"fem\"]"}, {"construction.1.duration", "10"}, {"construction.1.remove", "[\"lift\"]"}});
  const auto read = [&](const char* stage) {
    std::ifstream file(folder_ / stage / "summary.json");
    return nlohmann::json::parse(file);
  };
  const auto full = read("stage_1"), rest = read("stage_2");
  EXPECT_EQ(full.at("outlines").size(), 2u);
  ASSERT_EQ(rest.at("outlines").size(), 1u);
  EXPECT_EQ(rest.at("input").at("geometry").at("polygon").size(), 1u);
  EXPECT_TRUE(rest.at("input").at("construction").empty());
  for (const auto& warning : rest.at("warnings")) {
    const auto& all = summary.at("warnings");
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& w) {
      return w.template get<std::string>().find(warning.template get<std::string>()) != std::string::npos;
    })) << warning;
  }
}

TEST_F(ConstructionRuns, AFineStepDoesNotMoveTheResult) {
  const std::vector<input::Override> alone{
      {"analysis.methods", "[\"fem\"]"}, {"construction.0.factor", "false"}, {"construction.1.factor", "false"}};
  auto fine = alone;
  fine.push_back({"consolidation.tolerance", "2e-4"});
  const auto one = run(lift, alone), other = run(lift, fine);
  for (const std::size_t k : {0u, 1u}) {
    const auto& a = one.at("construction").at("stages")[k].at("steps").back();
    const auto& b = other.at("construction").at("stages")[k].at("steps").back();
    EXPECT_NEAR(a.at("settlement").get<double>(), b.at("settlement").get<double>(),
                5e-3 * b.at("settlement").get<double>());
  }
}

TEST_F(ConstructionRuns, ALiftThatIsTooHighFailsInItsStage) {
  const auto summary = run(lift, {{"fem.size", "2.5"},
                                  {"consolidation.iterations", "8"},
                                  {"construction.0.duration", "0"},
                                  {"materials.clay.cohesion", "1"},
                                  {"materials.clay.friction_angle", "12"},
                                  {"geometry.polygon.1.points", "[[0, 6], [14, 6], [12, 12], [0, 12]]"}});
  const auto& stages = summary.at("construction").at("stages");
  ASSERT_EQ(stages.size(), 1u);
  EXPECT_FALSE(stages[0].at("converged"));
  EXPECT_LT(stages[0].at("reached").get<double>(), 1);
  EXPECT_NE(stages[0].at("error").get<std::string>().find("no equilibrium beyond"), std::string::npos);
  EXPECT_TRUE(summary.at("main_factor").is_null());
}

TEST_F(ConstructionRuns, AFailureAfterAStageLeavesNoFactor) {
  // The first stage stands; its factor is not that of the construction, whose second one fails.
  const auto summary = run(lift, {{"fem.size", "2.5"},
                                  {"consolidation.iterations", "8"},
                                  {"construction.0.duration", "1"},
                                  {"construction.0.add", "[]"},
                                  {"construction.1.duration", "0"},
                                  {"construction.1.add", "[\"lift\"]"},
                                  {"analysis.methods", "[\"fem\"]"},
                                  {"materials.clay.cohesion", "1"},
                                  {"materials.clay.friction_angle", "12"},
                                  {"geometry.polygon.1.points", "[[0, 6], [14, 6], [12, 12], [0, 12]]"}});
  const auto& construction = summary.at("construction");
  ASSERT_EQ(construction.at("stages").size(), 2u);
  EXPECT_TRUE(construction.at("stages")[0].at("converged"));
  EXPECT_FALSE(construction.at("stages")[1].at("converged"));
  EXPECT_TRUE(construction.at("least").is_null());
  EXPECT_TRUE(summary.at("main_factor").is_null());
}

TEST_F(ConstructionRuns, SoilThatNothingBearsIsRefused) {
  try {
    run(lift, {{"construction.0.add", "[]"}, {"construction.1.remove", "[\"clay\"]"}, {"construction.0.remove", "[]"}});
    FAIL() << "the lift must not float";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nothing bears region 'lift' in stage 'rest'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace talus
