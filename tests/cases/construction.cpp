// SPDX-License-Identifier: MIT
// Stages of construction in a run: excess pressures that rise and fall, factors at the ends of stages with the pore
// pressures and stresses of the stage, excavation without water, and a lift that is too high.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/progress.hpp"
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

struct ConstructionRuns : MethodsTest {
  nlohmann::json read_stage(std::size_t number) const {
    std::ifstream file(folder_ / ("stage_" + std::to_string(number)) / "summary.json");
    return nlohmann::json::parse(file);
  }
};

TEST_F(ConstructionRuns, FactorsGrowWithConsolidation) {
  const auto summary = run(lift);
  const auto& construction = summary.at("construction");
  const auto& stages = construction.at("stages");
  ASSERT_EQ(stages.size(), 2u);
  for (std::size_t number = 0; const auto& stage : stages) {
    EXPECT_TRUE(stage.at("converged"));
    // LEM and FEM at the end of a stage have the same pore pressures. The polyline from FEM's shear band has less.
    const double lem = read_stage(++number).at("lem").at("critical")[0].at("factor");
    EXPECT_NEAR(stage.at("factors")[1].at("factor").get<double>(), lem, 0.05 * lem);
    for (const auto& step : stage.at("steps")) EXPECT_LT(step.at("residual").get<double>(), 1e-6);
  }
  // Without drainage the clay takes up pore pressure as it fails; at rest none is left to tell them apart.
  ASSERT_EQ(stages[0].at("factors").size(), 4u);
  EXPECT_EQ(stages[1].at("factors").size(), 2u);
  const auto get_factor = [&](std::size_t i) { return stages[0].at("factors")[i].at("factor").get<double>(); };
  for (std::size_t i = 2; i < 4; ++i) {
    EXPECT_TRUE(stages[0].at("factors")[i].at("undrained"));
    EXPECT_LT(get_factor(i), get_factor(1));
  }
  EXPECT_EQ(stages[0].at("least"), std::min(get_factor(2), get_factor(3)));
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
  const auto full = read_stage(1), rest = read_stage(2);
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

/// A line within the section has its condition from the stage on that exposes it.
TEST_F(ConstructionRuns, AnExposedLineDrains) {
  const std::string text = R"(
[[geometry.polygon]]
name = "ground"
points = [[0, 0], [20, 0], [20, 4], [12, 4], [8, 8], [0, 8]]
[[geometry.polygon]]
name = "cut"
points = [[12, 4], [20, 4], [20, 8], [8, 8]]
[[geometry.line]]
name = "floor"
points = [[20, 4], [12, 4], [8, 8]]
[[geometry.line]]
name = "back"
points = [[0, 0], [0, 8]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 19
porosity = 0.4
cohesion = 30
friction_angle = 25
dilatancy_angle = 0
tensile_strength = 30
young_modulus = "20 MPa"
poisson_ratio = 0.3
[materials.clay.water]
retention = "saturated"
conductivity = "1e-8 m/s"
[regions]
ground = "clay"
cut = "clay"
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 7], [20, 7]]
[[hydraulic]]
on = "back"
condition = "total_head"
head = 7
[[hydraulic]]
on = "floor"
condition = "seepage_face"
[analysis]
methods = ["fem"]
[fem]
size = 1
meshes = 1
[[output.monitor]]
name = "floor"
at = [16, 4]
[[output.monitor]]
name = "back"
at = [0, 2]
[[construction]]
name = "wait"
duration = 1
factor = false
[[construction]]
name = "cut"
duration = 30
remove = ["cut"]
drainage = "drained"
factor = false
)";
  const auto stages = run(text).at("construction");
  const auto &floor = stages.at("monitors")[0].at("pressure"), &back = stages.at("monitors")[1].at("pressure");
  EXPECT_NEAR(floor.front().get<double>(), 3 * 9810.0, 300) << "there is soil on both sides of the line";
  EXPECT_NEAR(floor.back().get<double>(), 0, 100);
  EXPECT_NEAR(back.back().get<double>(), 5 * 9810.0, 100);
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

TEST_F(ConstructionRuns, ASoilOfTheSameNumbersChangesNothing) {
  const std::string text = lift;
  const std::size_t from = text.find("[materials.clay]"), to = text.find("[materials.fill]");
  std::string twin = text.substr(from, to - from);
  for (std::size_t at = twin.find("clay"); at != std::string::npos; at = twin.find("clay", at + 4))
    twin.replace(at, 4, "twin");
  std::string both = text;
  both.insert(from, twin);
  const std::vector<input::Override> alone{{"analysis.methods", "[\"fem\"]"}, {"construction.1.factor", "false"}};
  auto changed = alone;
  changed.push_back({"construction.1.soils.clay", "\"twin\""});
  auto stronger = changed;
  stronger.push_back({"construction.1.factor", "true"});
  stronger.push_back({"materials.twin.cohesion", "20"});
  const auto one = run(lift, alone), other = run(both, changed), strong = run(both, stronger);
  const auto find_last = [](const nlohmann::json& summary) {
    return summary.at("construction").at("stages")[1].at("steps").back();
  };
  EXPECT_EQ(find_last(one).at("settlement"), find_last(other).at("settlement"));
  EXPECT_EQ(find_last(one).at("excess"), find_last(other).at("excess"));
  EXPECT_GT(strong.at("construction").at("stages")[1].at("least").get<double>(),
            1.2 * one.at("construction").at("stages")[0].at("least").get<double>());
}

TEST_F(ConstructionRuns, MonitorsAndLinesHaveTheirNumbers) {
  const std::vector<input::Override> alone{
      {"analysis.methods", "[\"fem\"]"}, {"construction.0.factor", "false"}, {"construction.1.factor", "false"}};
  const auto before = run(lift, alone);
  const auto& monitor = before.at("construction").at("monitors")[0];
  const double first = -monitor.at("displacement_y").back().get<double>();
  // Measurements that are the computed value at the end, and 2 mm more: the root mean square difference is 2 mm/√2. One
  // after the end does not count.
  const double end = before.at("construction").at("stages")[1].at("to");
  const std::string measured = fmt::format(
      "\n[[output.section]]\nname = \"ground\"\nfrom = [0, 6]\nto = [30, 6]\n"
      "[[output.section]]\nname = \"deep\"\nfrom = [2, 0]\nto = [2, 6]\n");
  std::string text = std::string(lift) + measured;
  const std::string at = "at = [2, 3]\n";
  text.insert(text.find(at) + at.size(),
              fmt::format("measured_settlement = [[\"{:.17g} s\", \"{:.17g} m\"], [\"{:.17g} s\", \"{:.17g} m\"], "
                          "[\"{:.17g} s\", 0]]\n",
                          end, first, end, first + 2e-3, 2 * end));
  const auto summary = run(text, alone);
  const auto& construction = summary.at("construction");
  EXPECT_NEAR(construction.at("monitors")[0].at("measured_settlement").at("rms").get<double>(), 2e-3 / std::sqrt(2.0),
              1e-9);
  const auto& results = summary.at("results");
  EXPECT_TRUE(std::any_of(results.begin(), results.end(), [](const auto& r) {
    return r.at("name") == "construction.monitor[middle].settlement_misfit";
  }));
  // The ground under the lift settles most at its middle; the settled line meets the largest settlement of the fields.
  const auto& lines = construction.at("lines");
  ASSERT_EQ(lines.size(), 2u);
  const auto& trough = lines[0].at("profiles")[1];
  EXPECT_EQ(trough.at("stage"), "rest");
  EXPECT_LT(trough.at("displacement_y")[0].get<double>(), 4 * trough.at("displacement_y").back().get<double>());
  // At rest the pressure is that of the water table.
  const auto& deep = lines[1].at("profiles")[1].at("pressure");
  const auto& distance = lines[1].at("distance");
  for (std::size_t i = 0; i < deep.size(); ++i)
    EXPECT_NEAR(deep[i].get<double>(), 9810 * (6 - distance[i].get<double>()), 1200);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "construction_2.vtu"));
  std::ifstream table(folder_ / "construction_monitors.csv");
  std::string header;
  std::getline(table, header);
  EXPECT_NE(header.find("middle.pore_pressure [Pa]"), std::string::npos) << header;
}

TEST_F(ConstructionRuns, AResumedRunGoesOnAfterTheStagesThatAreComputed) {
  const std::vector<input::Override> alone{{"analysis.methods", "[\"fem\"]"}, {"construction.1.factor", "false"}};
  auto whole = run(lift, alone);
  Progress interrupting(Progress::Listener([](const ProgressReport& report) {
    if (report.line.find("stage 'rest'") != std::string::npos) request_interrupt();
  }));
  progress_ = &interrupting;
  EXPECT_THROW(run(lift, alone), Error);
  request_interrupt(false);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "construction_state.json"));
  bool repeats = false;
  Progress watching([&](const ProgressReport& report) {
    repeats = repeats || report.line.find("stage 'lift'") != std::string::npos;
  });
  progress_ = &watching;
  auto resumed = run(lift, alone, true);
  progress_ = nullptr;
  EXPECT_FALSE(repeats);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "construction_state.json"));
  for (auto* summary : {&whole, &resumed}) {
    summary->at("construction").erase("seconds");
    EXPECT_EQ(summary->at("status"), "finished");
  }
  EXPECT_EQ(whole.at("construction"), resumed.at("construction"));
  EXPECT_EQ(whole.at("warnings"), resumed.at("warnings"));
}

/// A block of dry clay that stands, and a cut in front of it that is too steep.
const char* const cut = R"(
title = "Cut"
[geometry]
box = [[0, 0], [30, 9]]
[[geometry.polygon]]
name = "ground"
points = [[0, 0], [30, 0], [30, 2], [14, 2], [12, 8], [0, 8]]
[[geometry.polygon]]
name = "cut"
points = [[14, 2], [30, 2], [30, 8], [12, 8]]
[mesh]
size = 1
[materials.clay]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.4
cohesion = 6
friction_angle = 15
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "10 MPa"
poisson_ratio = 0.3
[regions]
ground = "clay"
cut = "clay"
[initial]
stress = "k0"
k0 = 0.6
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[analysis]
kind = "run"
methods = ["fem", "mpm"]
[fem]
size = 1.5
[output]
runout_meshes = 1
[[stage]]
name = "motion"
duration = 1.5
[[construction]]
name = "excavate"
duration = 1
remove = ["cut"]
release = true
)";

TEST_F(ConstructionRuns, SoilThatFailsInAStageMovesByMpm) {
  const auto summary = run(cut);
  const auto& stage = summary.at("construction").at("stages")[0];
  EXPECT_FALSE(stage.at("converged"));
  const auto& release = stage.at("release");
  EXPECT_TRUE(release.at("error").is_null()) << release.dump();
  EXPECT_EQ(release.at("folder"), "released_1");
  EXPECT_GT(release.at("largest_displacement").get<double>(), 0.3);
  EXPECT_GT(release.at("moved_volume").get<double>(), 5);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "released_1" / "summary.json"));
  // Soil that stands after the stage stays where it is.
  const auto stands = run(cut, {{"materials.clay.cohesion", "40"}});
  const auto& calm = stands.at("construction").at("stages")[0];
  EXPECT_TRUE(calm.at("converged"));
  EXPECT_LT(calm.at("release").at("largest_displacement").get<double>(), 0.02);
}

/// Terzaghi's layer of 6 m, drained at its top: at T = 0.1 a degree of 0.3568, and 0.9493 of the pressure at its base.
TEST_F(ConstructionRuns, ElasticSoilConsolidatesWithoutAFactor) {
  const nlohmann::json summary = run(R"(
geometry.polygon = [{ name = "clay", points = [[0, 0], [1, 0], [1, 6], [0, 6]] }]
geometry.line = [{ name = "ground", points = [[0, 6], [1, 6]] }]
mesh.size = 0.5
regions.clay = "clay"
initial = { stress = "k0", pore_pressure = "water_table", water_table = [[0, 6], [1, 6]] }
hydraulic = [{ on = "ground", condition = "total_head", head = 6 }]
surcharge = [{ name = "fill", x = [0, 1], load = [20, 20] }]
analysis.methods = ["fem"]
construction = [{ name = "fill", duration = 0, add = ["fill"], factor = false },
                { name = "pause", duration = 101.2146, factor = false },
                { name = "end", duration = 10000, factor = false }]
[materials.clay]
model = "linear_elastic"
grain_density = 2700
porosity = 0.5
young_modulus = 3000
poisson_ratio = 0.3
water = { retention = "saturated", conductivity = 1e-9 }
)");
  const auto& stages = summary.at("construction").at("stages");
  const double end = 20.0 * 6 / (3000 * 0.7 / (1.3 * 0.4));
  const auto& half = stages.at(1).at("steps").back();
  EXPECT_NEAR(half.at("settlement").get<double>(), 0.3568 * end, 0.01 * end);
  EXPECT_NEAR(half.at("excess").get<double>(), 0.9493 * 20e3, 200);
  EXPECT_NEAR(stages.at(2).at("steps").back().at("settlement").get<double>(), end, 0.002 * end);
  EXPECT_TRUE(stages.at(2).at("factors").empty());
}

/// A wide cut that fills with water: the pore pressure falls at once by the buoyant weight of what is removed.
TEST_F(ConstructionRuns, ACutHeavesAndHasSuction) {
  const nlohmann::json summary = run(R"(
construction = [{ name = "dig", duration = 0, remove = ["dug"], factor = false }]
geometry.polygon = [{ name = "soil", points = [[0, 0], [2, 0], [2, 6], [0, 6]] },
                    { name = "dug", points = [[0, 6], [2, 6], [2, 9], [0, 9]] }]
mesh.size = 1
regions = { soil = "soil", dug = "soil" }
initial = { stress = "k0", k0 = 0.5, pore_pressure = "water_table", water_table = [[0, 9], [2, 9]] }
analysis.methods = ["fem"]
[materials.soil]
model = "linear_elastic"
unit_weight = 20
porosity = 0.4
young_modulus = 12000
poisson_ratio = 0.25
water = { retention = "saturated", conductivity = 1e-12 }
)");
  const auto& step = summary.at("construction").at("stages").at(0).at("steps").back();
  const double buoyant = 3 * (20e3 - 9810);
  EXPECT_NEAR(step.at("least_excess").get<double>(), -buoyant, 0.005 * buoyant);
  EXPECT_EQ(step.at("excess"), 0);
}

}  // namespace
}  // namespace talus
