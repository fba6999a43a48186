// SPDX-License-Identifier: MIT
// Hydrostatic water under the water table of a case: its part in the soil, the ponded water, and its pressures.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "input/read.hpp"
#include "site/seepage_results.hpp"

namespace talus::site {
namespace {

/// A slope 2:1 from (10, 10) down to (22, 4), under a level table.
WaterResult make_slope_result(const std::string& more, const std::string& water = "") {
  const std::string text = R"(title = "A bank"
geometry.box = [[0, 0], [30, 12]]
geometry.polygon = [{ name = "bank", points = [[0, 0], [30, 0], [30, 4], [22, 4], [10, 10], [0, 10]] }]
geometry.line = [{ name = "floor", points = [[22, 4], [30, 4]] }]
mesh.size = 2
materials.clay = { model = "mohr_coulomb", grain_density = 2700, porosity = 0.4, cohesion = 5, friction_angle = 25)" +
                           water + R"( }
regions.bank = "clay"
analysis.methods = ["lem"]
)";
  return make_water_table_result(input::read_case_text(text + more, "bank.toml", {}).data);
}

TEST(WaterStates, ATableOverTheGroundIsAPond) {
  const WaterResult result =
      make_slope_result("initial = { pore_pressure = \"water_table\", water_table = [[0, 6], [30, 6]] }\n");
  ASSERT_TRUE(result.states && result.states->size() == 1);
  const results::WaterState& state = result.states->front();
  EXPECT_EQ(state.flow, results::WaterFlow::hydrostatic);
  ASSERT_EQ(state.water_table.size(), 1u);
  const auto& line = state.water_table.front();
  EXPECT_NEAR(line.front()[0], 0, 1e-9);
  EXPECT_NEAR(line.back()[0], 18, 1e-4) << "the table meets the face where that is 6 m high";
  ASSERT_EQ(state.ponds.size(), 2u) << "over the face, and over the floor";
  EXPECT_NEAR(state.ponds[0].from[0], 18, 1e-4);
  EXPECT_NEAR(state.ponds[0].from[1], 6, 1e-4);
  EXPECT_NEAR(state.ponds[1].to[0], 30, 1e-9);
  EXPECT_NEAR(state.ponds[1].to[1], 4, 1e-9);
  for (const results::StandingWater& pond : state.ponds) {
    EXPECT_NEAR(pond.level_from, 6, 1e-9);
    EXPECT_NEAR(pond.level_to, 6, 1e-9);
  }
}

TEST(WaterStates, ItsPressuresAreHydrostaticAndSuctionIsCut) {
  const WaterResult result = make_slope_result(
      "initial = { pore_pressure = \"water_table\", water_table = [[0, 6], [30, 6]], largest_suction = \"20 kPa\" }\n");
  ASSERT_TRUE(result.fields);
  const results::WaterFields& fields = *result.fields;
  ASSERT_EQ(fields.states.size(), 1u);
  double highest = 0;
  for (std::size_t i = 0; i < fields.nodes.size(); ++i) {
    const double depth = 6 - fields.nodes[i][1];
    EXPECT_NEAR(fields.states[0].pressure[i], std::max(fields.unit_weight * depth, -20e3), 1) << fields.nodes[i][1];
    highest = std::max(highest, fields.nodes[i][1]);
  }
  EXPECT_NEAR(highest, 10, 1e-9);
  for (const auto& element : fields.elements)
    for (const int node : element) ASSERT_LT(static_cast<std::size_t>(node), fields.nodes.size());
}

/// A bank whose lower left corner is at (x, y), under a table that falls from 3 m below its crest to its toe.
WaterResult make_bank_result(double x, double y) {
  const auto at = [&](double dx, double dy) { return fmt::format("[{:.2f}, {:.2f}]", x + dx, y + dy); };
  const std::string polygon =
      fmt::format("{}, {}, {}, {}, {}, {}", at(0, 0), at(30, 0), at(30, 4), at(22, 4), at(10, 10), at(0, 10));
  const std::string table = fmt::format("{}, {}, {}", at(0, 7), at(10, 6.5), at(30, 4));
  const std::string text =
      "title = \"A bank\"\n"
      "geometry.polygon = [{ name = \"bank\", points = [" +
      polygon +
      "] }]\n"
      "materials.clay = { model = \"mohr_coulomb\", unit_weight = 18, cohesion = 5, friction_angle = 25 }\n"
      "regions.bank = \"clay\"\nanalysis.methods = [\"lem\"]\n"
      "initial = { pore_pressure = \"water_table\", water_table = [" +
      table + "] }\n";
  return make_water_table_result(input::read_case_text(text, "bank.toml", {}).data);
}

TEST(WaterStates, FieldsOfAMapAreThoseOfTheOrigin) {
  const double x = 500000.25, y = 4000000.5;
  const WaterResult here = make_bank_result(0, 0), there = make_bank_result(x, y);
  ASSERT_TRUE(here.fields && there.fields);
  ASSERT_EQ(here.fields->nodes.size(), there.fields->nodes.size());
  for (std::size_t i = 0; i < here.fields->nodes.size(); ++i) {
    EXPECT_NEAR(there.fields->nodes[i][0] - x, here.fields->nodes[i][0], 2e-5);
    EXPECT_NEAR(there.fields->nodes[i][1] - y, here.fields->nodes[i][1], 2e-5);
    EXPECT_NEAR(there.fields->states[0].pressure[i], here.fields->states[0].pressure[i], 1);
  }
}

TEST(WaterStates, APondOfAConditionReplacesTheTable) {
  const WaterResult result = make_slope_result(
      "initial = { pore_pressure = \"water_table\", water_table = [[0, 3], [30, 3]] }\n"
      "hydraulic = [{ on = \"floor\", condition = \"total_head\", head = 5 }]\n",
      ", water = { retention = \"saturated\", conductivity = \"1e-7 m/s\" }");
  ASSERT_TRUE(result.states);
  const results::WaterState& state = result.states->front();
  ASSERT_EQ(state.ponds.size(), 1u);
  EXPECT_NEAR(state.ponds[0].level_from, 5, 1e-9);
  EXPECT_NEAR(state.ponds[0].from[0], 22, 1e-9);
  ASSERT_EQ(state.water_table.size(), 1u);
  EXPECT_NEAR(state.water_table[0].back()[0], 22, 1e-4) << "no table under the pond";
}

TEST(WaterStates, DryGroundHasNone) {
  const WaterResult result = make_slope_result("");
  EXPECT_FALSE(result.states);
  EXPECT_FALSE(result.fields);
}

}  // namespace
}  // namespace talus::site
