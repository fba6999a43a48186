// SPDX-License-Identifier: MIT
// Steady pore pressures of stages of construction: what a drained stage leads to, and what excess is counted from.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fem/consolidation/consolidation.hpp"
#include "physics/seepage_box.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810;

/// A column of clay 10 m high in two parts, 7 and 3 m; E_oed = E (1 − ν)/((1 + ν)(1 − 2ν)).
std::string write_column(double water_table, const std::string& more) {
  return fmt::format(R"(
analysis.methods = ["fem"]
fem = {{ size = 1, meshes = 1 }}
geometry.polygon = [{{ name = "c", points = [[0, 0], [1, 0], [1, 7], [0, 7]] }},
                    {{ name = "d", points = [[0, 7], [1, 7], [1, 10], [0, 10]] }}]
geometry.line = [{{ name = "ground", points = [[0, 10], [1, 10]] }}, {{ name = "floor", points = [[0, 7], [1, 7]] }}]
regions = {{ c = "clay", d = "clay" }}
[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
porosity = 0.5
cohesion = 2000
friction_angle = 25
dilatancy_angle = 0
tensile_strength = 2000
young_modulus = "5 MPa"
poisson_ratio = 0.3
[materials.clay.water]
retention = "saturated"
conductivity = "1e-6 m/s"
[initial]
stress = "k0"
k0 = 0.5
pore_pressure = "water_table"
water_table = [[0, {0}], [1, {0}]]
[[output.section]]
name = "axis"
from = [0.5, 0]
to = [0.5, 7]
{1})",
                     water_table, more);
}

constexpr double column_modulus = 5e6 * 0.7 / (1.3 * 0.4), dug_weight = 3 * 18e3;

const char* const dig_stage = R"(
[[construction]]
name = "dig"
duration = 1
drainage = "drained"
remove = ["d"]
factor = false
)";

nlohmann::json run(const std::string& text) {
  run::RunOptions options;
  options.folder = support::make_scratch("consolidation_water") / "run";
  options.overwrite = true;
  return support::run_case(input::read_case_text(text, "stages.toml"), options);
}

bool warns(const nlohmann::json& summary, const std::string& part) {
  for (const auto& warning : summary.at("warnings"))
    if (warning.get<std::string>().find(part) != std::string::npos) return true;
  return false;
}

TEST(ConsolidationWater, StaysWhereNothingGivesAHead) {
  // Water table at the base and suction above it: the drained excavation releases the weight alone.
  const auto summary = run(write_column(0, dig_stage));
  const auto& end = summary.at("construction").at("stages")[0].at("steps").back();
  EXPECT_NEAR(end.at("heave").get<double>(), dug_weight * 7 / column_modulus, 1e-3 * 0.056);
  EXPECT_NEAR(end.at("excess").get<double>(), 0, 1);
  EXPECT_TRUE(warns(summary, "stage 'dig' is drained, and no [[hydraulic]] gives a head"));
}

TEST(ConsolidationWater, SuctionOfACutCounts) {
  // Without drainage the water bears the weight that is dug out, above and below the water table at 5 m, but for the
  // part of the soil, which is strained as the water expands: n E_oed/K_w of it.
  const double borne = dug_weight / (1 + 0.5 * column_modulus / 2.2e9);
  std::string undrained = dig_stage;
  undrained.replace(undrained.find("drainage = \"drained\""), 20, "drainage = \"undrained\"");
  const auto summary = run(write_column(5, undrained));
  const auto& end = summary.at("construction").at("stages")[0].at("steps").back();
  EXPECT_NEAR(end.at("least_excess").get<double>(), -borne, 1e-4 * borne);
  EXPECT_NEAR(end.at("excess").get<double>(), 0, 1e-4 * borne);
}

TEST(ConsolidationWater, StandsOnTheGroundBelowTheWaterTable) {
  // The water table at 9 m stands on the floor at 7 m: its pore pressures stay and its weight presses.
  const auto summary = run(write_column(9, dig_stage));
  const auto& construction = summary.at("construction");
  const auto& end = construction.at("stages")[0].at("steps").back();
  EXPECT_NEAR(end.at("heave").get<double>(), (dug_weight - 2 * gamma_w) * 7 / column_modulus, 1e-3 * 0.056);
  const auto& axis = construction.at("lines")[0].at("profiles")[0];
  EXPECT_NEAR(axis.at("pressure")[0].get<double>(), 9 * gamma_w, 1);
  EXPECT_NEAR(axis.at("excess")[0].get<double>(), 0, 1);
  EXPECT_FALSE(warns(summary, "is drained"));
}

TEST(ConsolidationWater, FallsToTheFaceAtWhichItLeaves) {
  // A closed column of 7 m with a face at its top: water above the face leaves, less water stays.
  const auto mesh = support::make_soil_box<2>({2, 14}, {1, 7});
  support::SeepageModel<2> flow{&mesh, {support::make_soil<2>(1e-6)}, {}};
  flow.boundaries = {support::make_condition(mesh, "top", support::HydraulicKind::seepage_face)};
  for (const double kept : {9.0, 5.0}) {
    const auto steady = fem::find_steady_heads<2>(flow, std::vector<double>(mesh.nodes.size(), kept), 0);
    EXPECT_FALSE(steady.is_given);
    EXPECT_EQ(steady.is_lowered, kept > 7);
    for (const double head : steady.head) EXPECT_NEAR(head, std::min(kept, 7.0), 1e-9);
  }
  // Water that enters below has a steady flow of its own, whatever was there before.
  flow.boundaries.push_back(support::make_condition(mesh, "bottom", support::HydraulicKind::flux, 1e-7));
  const auto steady = fem::find_steady_heads<2>(flow, std::vector<double>(mesh.nodes.size(), 5), 0);
  EXPECT_TRUE(steady.is_given);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_NEAR(steady.head[i], 7 + 0.1 * (7 - mesh.nodes[i][1]), 1e-6);
}

TEST(ConsolidationWater, FollowsAGivenHead) {
  const auto summary = run(write_column(
      9, std::string("[[hydraulic]]\non = \"floor\"\ncondition = \"total_head\"\nhead = 8\n") + dig_stage));
  EXPECT_NEAR(summary.at("construction").at("lines")[0].at("profiles")[0].at("pressure")[0].get<double>(), 8 * gamma_w,
              1);
  EXPECT_FALSE(warns(summary, "is drained"));
}

TEST(ConsolidationWater, ExcessIsCountedFromTheSteadyFlowOfTheTime) {
  // A pool rises from 11 to 16 m above the closed column within ten days, and stays: all of the rise is pore pressure,
  // of which none is excess in the end.
  const auto summary = run(write_column(11, R"(
[[hydraulic]]
on = "ground"
condition = "total_head"
head = [["0 day", 11], ["10 day", 16]]
[[construction]]
name = "filling"
duration = 10
factor = false
[[construction]]
name = "steady"
duration = 3000
factor = false
)"));
  const auto& construction = summary.at("construction");
  const auto& axis = construction.at("lines")[0].at("profiles")[1];
  EXPECT_NEAR(axis.at("pressure")[0].get<double>(), 16 * gamma_w, 0.002 * 16 * gamma_w);
  for (const auto& step : construction.at("stages")[0].at("steps"))
    EXPECT_LT(step.at("excess").get<double>(), 2 * gamma_w) << "the pool compresses soil and water alike";
  EXPECT_LT(construction.at("stages")[1].at("steps").back().at("excess").get<double>(), 0.01 * gamma_w);
}

TEST(ConsolidationWater, SuctionBelowTheSteadyOneIsNoExcess) {
  EXPECT_DOUBLE_EQ(fem::find_excess(30e3, 10e3), 20e3);
  EXPECT_DOUBLE_EQ(fem::find_excess(-5e3, 10e3), -15e3);
  EXPECT_DOUBLE_EQ(fem::find_excess(5e3, -20e3), 5e3);
  EXPECT_DOUBLE_EQ(fem::find_excess(-5e3, -20e3), 0);
  EXPECT_DOUBLE_EQ(fem::find_excess(-30e3, -20e3), -10e3);
}

}  // namespace
}  // namespace talus
