// SPDX-License-Identifier: MIT
// Excavations with supports, stage by stage: a cut that is nailed from the top down, a sheet pile that is placed before
// the pit is dug, an anchor that keeps its prestress, struts, and stages in which nothing happens.

#include <algorithm>
#include <cmath>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

const std::string settings = R"(
[initial]
stress = "k0"
k0 = 0.5
[fem]
size = 2
meshes = 1
resolution = 0.01
[lem]
methods = ["spencer"]
noncircular = false
yield_acceleration = false
minima = 1
referee = false
[lem.entry_exit]
exits = 10
entries = 10
depths = 8
)";

std::string write_soil(double cohesion, double friction) {
  return fmt::format(R"([materials.soil]
model = "mohr_coulomb"
unit_weight = 20
cohesion = {}
friction_angle = {}
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
)",
                     cohesion, friction);
}

/// A nail of the cut with its head at a place.
std::string write_nail(const char* name, const char* head) {
  return fmt::format(
      "[support.{}]\nkind = \"nail\"\nheads = [{}]\ninclination = 10\nlength = 6\nout_of_plane_spacing = 1.5\n"
      "tensile_strength = 120\nplate = 60\nbond = 18\naxial_stiffness = 1.2e5\n",
      name, head);
}

/// A cut of 6 m, which is nailed; `regions`: what is dug out.
std::string write_cut(const std::string& regions, const std::string& stages,
                      const std::string& methods = "[\"lem\", \"fem\"]") {
  std::string soils = "[regions]\nground = \"soil\"\n";
  for (const char* name : {"cut_1", "cut_2", "cut_3"})
    if (regions.find(name) != std::string::npos) soils += fmt::format("{} = \"soil\"\n", name);
  return "title = \"Nailed cut\"\n[[geometry.polygon]]\nname = \"ground\"\n"
         "points = [[0, -4], [26, -4], [26, 0], [13, 0], [12.5, 2], [12, 4], [11.5, 6], [0, 6]]\n" +
         regions + soils + write_soil(6, 32) + write_nail("row_1", "[11.75, 5]") + write_nail("row_2", "[12.25, 3]") +
         write_nail("row_3", "[12.75, 1]") + "[analysis]\nmethods = " + methods + settings + stages;
}

const std::string cuts = R"([[geometry.polygon]]
name = "cut_1"
points = [[12, 4], [26, 4], [26, 6], [11.5, 6]]
[[geometry.polygon]]
name = "cut_2"
points = [[12.5, 2], [26, 2], [26, 4], [12, 4]]
[[geometry.polygon]]
name = "cut_3"
points = [[13, 0], [26, 0], [26, 2], [12.5, 2]]
)";

const std::string nailing = R"([[construction]]
name = "cut to 4 m"
duration = 5
remove = ["cut_1"]
add = ["row_1"]
[[construction]]
name = "cut to 2 m"
duration = 5
remove = ["cut_2"]
add = ["row_2"]
[[construction]]
name = "cut to the bottom"
duration = 5
remove = ["cut_3"]
add = ["row_3"]
)";

const std::string nothing = "[[construction]]\nname = \"nothing\"\nduration = 5\n";

double find_stage_factor(const nlohmann::json& stage, const char* method) {
  for (const auto& f : stage.at("factors"))
    if (f.at("method") == method) return f.at("factor");
  return 0;
}

class StagedSupports : public MethodsTest {};

TEST_F(StagedSupports, CutNailedFromTheTopEndsAsTheFinishedCut) {
  const auto staged = run(write_cut(cuts, nailing)), finished = run(write_cut("", ""));
  const auto& stages = staged.at("construction").at("stages");
  ASSERT_EQ(stages.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(stages[k].at("converged"));
    EXPECT_EQ(stages[k].at("supports").size(), k + 1);
    EXPECT_GT(find_stage_factor(stages[k], "fem"), 1);
  }
  // The factors fall as the cut is dug, and the last one is that of the finished slope.
  for (const char* method : {"lem", "fem"})
    for (std::size_t k = 1; k < 3; ++k)
      EXPECT_LT(find_stage_factor(stages[k], method), find_stage_factor(stages[k - 1], method)) << method << k;
  const double weakest = finished.at("main_factor");
  EXPECT_NEAR(find_stage_factor(stages[2], "lem"), weakest, 0.02 * weakest) << "polylines start from FEM's shear band";
  EXPECT_NEAR(find_stage_factor(stages[2], "fem"), finished.at("fem").at("runs")[0].at("factor").get<double>(), 0.02);
  // Each row takes up force as the soil below it is dug out.
  EXPECT_GT(stages[2].at("supports")[0].at("largest_force").get<double>(),
            stages[0].at("supports")[0].at("largest_force").get<double>());
}

TEST_F(StagedSupports, AStageInWhichNothingHappensChangesNothing) {
  const auto without = run(write_cut("", "")), with = run(write_cut("", nothing));
  const auto& stage = with.at("construction").at("stages")[0];
  EXPECT_NEAR(find_stage_factor(stage, "fem"), without.at("fem").at("runs")[0].at("factor").get<double>(), 0.01);
  EXPECT_LT(stage.at("steps").back().at("settlement").get<double>(), 1e-5);
  // The stage starts LEM's polylines from a shear band that differs by rounding.
  EXPECT_NEAR(with.at("main_factor").get<double>(), without.at("main_factor").get<double>(),
              0.02 * without.at("main_factor").get<double>());
}

/// A sheet pile of 6 m along a pit of 3 m in sand, which is dug in two steps; `dug`: from the beginning.
std::string write_pit(const std::string& stages, const std::string& more = "", bool dug = false) {
  const std::string pit = R"([[geometry.polygon]]
name = "cut_1"
points = [[12, 2], [24, 2], [24, 3], [12, 3]]
[[geometry.polygon]]
name = "cut_2"
points = [[12, 0], [24, 0], [24, 2], [12, 2]]
)";
  return std::string(
             "title = \"Pit\"\n[[geometry.polygon]]\nname = \"ground\"\n"
             "points = [[0, -6], [24, -6], [24, 0], [12, 0], [12, 3], [0, 3]]\n") +
         (dug ? "" : pit) + "[regions]\nground = \"soil\"\n" + (dug ? "" : "cut_1 = \"soil\"\ncut_2 = \"soil\"\n") +
         write_soil(0.2, 35) +
         "[support.sheet]\nkind = \"wall\"\nline = [[12, 3], [12, -3]]\naxial_stiffness = 2e6\n"
         "bending_stiffness = 5e4\nplastic_moment = 1800\ninterface_strength = 0.1\n" +
         more + "[analysis]\nmethods = [\"fem\"]\n" + settings + stages;
}

std::string write_stage(const char* name, const char* changes, bool factor = false) {
  return fmt::format("[[construction]]\nname = \"{}\"\nduration = 1\nfactor = {}\n{}\n", name, factor, changes);
}

const std::string wall_first = write_stage("wall", "add = [\"sheet\"]");

TEST_F(StagedSupports, APitBesideAWallEndsAsTheFinishedPit) {
  const auto staged = run(write_pit(wall_first + write_stage("dig", "remove = [\"cut_1\", \"cut_2\"]", true))),
             finished = run(write_pit("", "", true));
  const auto& stages = staged.at("construction").at("stages");
  ASSERT_EQ(stages.size(), 2u);
  // The wall is placed without a change of the stress of the soil.
  EXPECT_LT(stages[0].at("start_imbalance").get<double>(), 0.05);
  const auto &placed = stages[0].at("supports")[0], &dug = stages[1].at("supports")[0];
  EXPECT_LT(std::abs(placed.at("largest_deflection").get<double>()), 1e-4);
  EXPECT_LT(placed.at("largest_moment").get<double>(), 0.05 * dug.at("largest_moment").get<double>());
  // The retained soil presses on the wall with the active pressure at least: M = γ K_a H³/6 at the bottom of the pit.
  EXPECT_GT(dug.at("largest_moment").get<double>(), 24.4e3);
  EXPECT_GT(dug.at("largest_deflection").get<double>(), 1e-3) << "the head moves into the pit";
  const double factor = finished.at("fem").at("runs")[0].at("factor");
  EXPECT_NEAR(find_stage_factor(stages[1], "fem"), factor, 0.02 * factor);
}

TEST_F(StagedSupports, AnAnchorKeepsItsPrestressUntilTheEndOfItsStage) {
  const std::string tie =
      "[support.tie]\nkind = \"anchor\"\nheads = [[12, 2.5]]\ninclination = 15\nlength = 9\nbond_length = 4\n"
      "out_of_plane_spacing = 2\ntensile_strength = 400\nplate = 400\nbond = 80\nprestress = 60\n"
      "axial_stiffness = 1e5\n";
  const auto stages =
      run(write_pit(wall_first + write_stage("cut", "remove = [\"cut_1\"]") + write_stage("anchor", "add = [\"tie\"]") +
                        write_stage("rest", "") + write_stage("dig", "remove = [\"cut_2\"]") +
                        write_stage("loose", "remove = [\"tie\"]"),
                    tie))
          .at("construction")
          .at("stages");
  ASSERT_EQ(stages.size(), 6u);
  const auto find_force = [&](std::size_t k) { return stages[k].at("supports")[0].at("force")[0].get<double>(); };
  EXPECT_NEAR(find_force(2), 30e3, 1) << "60 kN at 2 m";
  EXPECT_NEAR(find_force(3), 30e3, 30) << "nothing moves";
  EXPECT_GT(find_force(4), 30.3e3) << "the wall pulls at it";
  const auto find_head = [&](std::size_t k) {
    return stages[k].at("supports").back().at("deflection")[0].get<double>();
  };
  EXPECT_LT(find_head(2), find_head(1)) << "it pulls the wall back";
  EXPECT_GT(find_head(5), find_head(4) + 1e-4) << "and the wall gives way without it";
  EXPECT_EQ(stages[5].at("supports").size(), 1u);
}

TEST_F(StagedSupports, StrutsCarryWhatIsDugAfterThem) {
  const std::string struts = "strut_levels = [2.5]\nstrut_stiffness = 2e4\nstrut_strength = 200\n";
  const auto stages =
      run(write_pit(wall_first + write_stage("cut", "remove = [\"cut_1\"]") +
                        write_stage("strut", "add = [\"sheet.strut_1\"]") + write_stage("dig", "remove = [\"cut_2\"]") +
                        write_stage("loose", "remove = [\"sheet.strut_1\"]"),
                    struts))
          .at("construction")
          .at("stages");
  ASSERT_EQ(stages.size(), 5u);
  const auto find_wall = [&](std::size_t k) { return stages[k].at("supports")[0]; };
  EXPECT_FALSE(find_wall(1).contains("struts"));
  EXPECT_NEAR(find_wall(2).at("struts")[0].get<double>(), 0, 10) << "it is placed without force";
  const double force = find_wall(3).at("struts")[0];
  EXPECT_GT(force, 1e3);
  const auto find_deflection = [&](std::size_t k) {  // half a metre below the head
    const auto wall = find_wall(k);
    const auto &place = wall.at("deflection_place"), &value = wall.at("deflection");
    std::size_t i = 1;
    while (place[i].get<double>() < 0.5) ++i;
    const double from = place[i - 1], to = place[i], t = (0.5 - from) / (to - from);
    return (1 - t) * value[i - 1].get<double>() + t * value[i].get<double>();
  };
  // The strut is shortened by the motion of the wall beside it since it was placed.
  EXPECT_NEAR(find_deflection(3) - find_deflection(2), force / 2e7, 0.1 * force / 2e7);
  EXPECT_GT(find_deflection(4), find_deflection(3) + 1e-4);
}

/// Water stands at y = 1 behind the wall, which reaches the base, and is lowered to the bottom of the pit in front.
TEST_F(StagedSupports, AnImpermeableWallKeepsTheWaterBehindIt) {
  std::string text =
      write_pit(wall_first + write_stage("cut", "remove = [\"cut_1\", \"cut_2\"]\ndrainage = \"drained\""),
                R"(permeable = false
[[geometry.line]]
name = "far"
points = [[0, -6], [0, 3]]
[[geometry.line]]
name = "floor"
points = [[12, 0], [24, 0]]
[[hydraulic]]
on = "far"
condition = "total_head"
head = 1
[[hydraulic]]
on = "floor"
condition = "seepage_face"
[[output.monitor]]
name = "behind"
at = [11, -2]
[[output.monitor]]
name = "inside"
at = [13, -2]
)");
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("poisson_ratio = 0.3\n",
          "poisson_ratio = 0.3\nporosity = 0.4\n[materials.soil.water]\nretention = \"saturated\"\n"
          "conductivity = \"1e-6 m/s\"\n");
  replace("k0 = 0.5\n", "k0 = 0.5\npore_pressure = \"water_table\"\nwater_table = [[0, 1], [24, 1]]\n");
  replace("[12, -3]]", "[12, -6]]");
  replace("interface_strength = 0.1", "interface_strength = 0.5");
  const auto construction = run(text).at("construction");
  const auto& monitors = construction.at("monitors");
  for (const std::size_t i : {0, 1}) EXPECT_NEAR(monitors[i].at("pressure")[0].get<double>(), 3 * 9810.0, 50);
  EXPECT_NEAR(monitors[0].at("pressure").back().get<double>(), 3 * 9810.0, 50);
  EXPECT_NEAR(monitors[1].at("pressure").back().get<double>(), 2 * 9810.0, 50);
  EXPECT_TRUE(construction.at("stages")[1].at("converged"));
  EXPECT_LT(construction.at("stages")[0].at("start_imbalance").get<double>(), 0.05);
}

/// The strutted sheet pile of CUR 166 by FEM of KratosMultiphysics (applications/GeoMechanicsApplication,
/// crow_validation): moments −101.38 and −338.98 kNm/m, strut 77.9 and 142.2 kN/m at pits of 5 and 8 m; subgrade
/// reaction has −309.96 and 140.6 at 8 m. Meshes and interfaces differ; the band was set after the first run.
TEST_F(StagedSupports, TheStruttedPileOfCur166HasTheForcesOfAnotherProgram) {
  run::RunOptions options;
  options.folder = support::make_scratch("strutted_pile");
  const auto result = support::run_case(
      input::read_case(std::string(TALUS_SOURCE_DIR) + "/examples/anchored_pit/strutted_pile.toml", {}), options);
  const auto& stages = result["construction"]["stages"];
  const auto find = [&](std::size_t stage, const char* key) { return stages[stage]["supports"][0][key]; };
  constexpr double band = 0.03;
  EXPECT_NEAR(find(3, "largest_moment").template get<double>(), 101.38e3, band * 101.38e3);
  EXPECT_NEAR(find(4, "largest_moment").template get<double>(), 338.98e3, band * 338.98e3);
  EXPECT_NEAR(find(3, "struts")[0].template get<double>(), 77.9e3, band * 77.9e3);
  EXPECT_NEAR(find(4, "struts")[0].template get<double>(), 142.2e3, band * 142.2e3);
}

}  // namespace
}  // namespace talus
