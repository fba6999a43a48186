// SPDX-License-Identifier: MIT
// Cases whose answer once misled: each with the number that governs, and what must be said about it.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class Misleading : public MethodsTest {
 protected:
  json run_case(const std::string& name, const std::vector<input::Override>& overrides = {}) {
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/" + name + ".toml");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return run(text, overrides);
  }

  /// Whether a warning holds all of the words.
  static bool warns(const json& summary, const std::vector<std::string>& words) {
    for (const std::string warning : summary.at("warnings")) {
      const auto is_in = [&](const std::string& word) { return warning.find(word) != std::string::npos; };
      if (std::all_of(words.begin(), words.end(), is_in)) return true;
    }
    return false;
  }
};

TEST_F(Misleading, TheBedGovernsAndNotTheCircleAboveIt) {
  const json summary = run_case("bedding_storm");
  EXPECT_NEAR(summary.at("main_factor").get<double>(), 1.006, 0.01);
  EXPECT_GT(find_factor(summary, "spencer"), 1.2);
  EXPECT_EQ(support::find_result(summary, "lem.factor"), summary.at("main_factor").get<double>());
  EXPECT_TRUE(warns(summary, {"critical polyline", "bedding", "governs"})) << summary.at("warnings");
}

TEST_F(Misleading, FelleniusDoesNotFallToZeroUnderAFullPool) {
  const json summary = run_case("dam_full_pool", {{"lem.methods", "[\"fellenius\", \"spencer\"]"}});
  const double spencer = find_factor(summary, "spencer");
  EXPECT_NEAR(spencer, 1.74, 0.02);
  EXPECT_GT(find_factor(summary, "fellenius"), 0.7 * spencer);
  EXPECT_EQ(summary.at("main_factor").get<double>(), spencer) << "Fellenius is lower, and leaves more out";
}

TEST_F(Misleading, NoFactorHasForcesThatNoSoilBears) {
  const json summary = run_case("steep_cut");
  int count = 0;
  for (const char* list : {"critical", "noncircular"})
    for (const json& c : summary.at("lem").at(list)) {
      if (c.at("lambda").is_null()) continue;
      EXPECT_LE(std::abs(c.at("lambda").get<double>() - 0.625), 0.875) << c.at("method");
      ++count;
    }
  EXPECT_GE(count, 3);
}

TEST_F(Misleading, MethodsOnBothSidesOfOneAreTheFirstWarningAndTheSmallestFactorGoverns) {
  const json summary = run_case("methods_on_both_sides_of_one");
  EXPECT_LT(summary.at("main_factor").get<double>(), 0.75);
  const auto& warnings = summary.at("warnings");
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].get<std::string>().find("disagree on whether the slope stands"), std::string::npos) << warnings;
  EXPECT_TRUE(warns(summary, {"unstable by inspection", "φ = 37.1°", "0.60"})) << warnings;
}

/// Enough of slices where the water is what is asked.
const std::vector<input::Override> few_surfaces{{"lem.noncircular", "false"},
                                                {"lem.methods", "[\"bishop\"]"},
                                                {"lem.entry_exit.entries", "12"},
                                                {"lem.entry_exit.exits", "12"}};

/// The level of the water that stands on the ground at the toe [m].
double find_pond(const json& state) {
  double level = 0;
  for (const json& pond : state.at("ponds"))
    if (pond.at("from")[0].get<double>() <= 60 && 60 <= pond.at("to")[0].get<double>())
      level = pond.at("level_from").get<double>();
  return level;
}

/// Height of the lines of zero pressure at x [m]; 0 where there is none.
double find_table(const json& state, double x) {
  double height = 0;
  for (const json& line : state.at("water_table"))
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double x0 = line[i - 1][0], y0 = line[i - 1][1], x1 = line[i][0], y1 = line[i][1];
      if (std::min(x0, x1) <= x && x <= std::max(x0, x1) && x0 != x1)
        height = std::max(height, y0 + (y1 - y0) * (x - x0) / (x1 - x0));
    }
  return height;
}

/// How many slices of the critical surfaces were found in the last field; their pressures are those of that field.
int compare_pressures(const json& summary, const json& fields) {
  const json& nodes = fields.at("nodes");
  const json& pressure = fields.at("states").back().at("pressure");
  int compared = 0;
  for (const json& surface : summary.at("lem").at("critical")) {
    const json& slices = surface.at("slices");
    for (std::size_t i = 0; i < slices.at("left").size(); ++i) {
      const double u = slices.at("pore_pressure")[i];
      const double x = (slices["base_left"][i][0].get<double>() + slices["base_right"][i][0].get<double>()) / 2;
      const double y = (slices["base_left"][i][1].get<double>() + slices["base_right"][i][1].get<double>()) / 2;
      for (const json& e : fields.at("elements")) {
        double at[3][2];
        for (int k = 0; k < 3; ++k)
          for (int d = 0; d < 2; ++d) at[k][d] = nodes[e[k].get<std::size_t>()][d];
        const double area =
            (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[2][0] - at[0][0]) * (at[1][1] - at[0][1]);
        const double b = ((x - at[0][0]) * (at[2][1] - at[0][1]) - (at[2][0] - at[0][0]) * (y - at[0][1])) / area;
        const double c = ((at[1][0] - at[0][0]) * (y - at[0][1]) - (x - at[0][0]) * (at[1][1] - at[0][1])) / area;
        if (b < 1e-3 || c < 1e-3 || b + c > 1 - 1e-3) continue;
        const double told = (1 - b - c) * pressure[e[0].get<std::size_t>()].get<double>() +
                            b * pressure[e[1].get<std::size_t>()].get<double>() +
                            c * pressure[e[2].get<std::size_t>()].get<double>();
        EXPECT_NEAR(u, told, 5) << "at (" << x << ", " << y << ")";
        ++compared;
      }
    }
  }
  return compared;
}

TEST_F(Misleading, TheWaterAfterADrawdownIsToldApartFromThatBefore) {
  std::vector<input::Override> overrides = few_surfaces;
  overrides.push_back({"mesh.size", "1.5"});
  const json summary = run_case("drawdown", overrides);
  const json& states = summary.at("water_states");
  ASSERT_EQ(states.size(), 11u);
  const json &before = states.front(), &after = states.back();
  EXPECT_EQ(before.at("flow"), "steady");
  EXPECT_EQ(before.at("time").get<double>(), -3 * 86400);
  EXPECT_NEAR(find_pond(before), 17, 1e-9);
  EXPECT_EQ(before.at("discharges"), summary.at("seepage").at("discharges"));
  EXPECT_EQ(after.at("flow"), "transient");
  EXPECT_EQ(after.at("time").get<double>(), 0);
  EXPECT_NEAR(find_pond(after), 9, 1e-9);
  EXPECT_TRUE(summary.contains("season"));
  // Half way down, by the series of the head.
  EXPECT_NEAR(find_pond(states[5]), 13, 1e-9);
  // In clay the water stays behind the face that the pool has left, and comes out above the pool.
  EXPECT_GT(find_table(after, 30), 12);
  EXPECT_LT(find_table(after, 30), find_table(before, 28) + 0.1);
  ASSERT_EQ(after.at("exits").size(), 1u);
  EXPECT_GT(after.at("exits")[0].at("highest")[1].get<double>(), 9.5);
  // What leaves the face was stored: little of it comes in.
  EXPECT_GT(after.at("outflow").get<double>(), 5 * after.at("inflow").get<double>());
  const double open =
      after.at("inflow").get<double>() - after.at("outflow").get<double>() - after.at("storage_rate").get<double>();
  EXPECT_LT(std::abs(open), 1e-6 * after.at("outflow").get<double>());
  // The slices took the pressures of the last state, and no others.
  EXPECT_GT(compare_pressures(summary, json::parse(std::ifstream(folder_ / "water.json"))), 20);
}

TEST_F(Misleading, AFullPoolIsToldWithItsLevel) {
  const json summary = run_case("pond", few_surfaces);
  const json& states = summary.at("water_states");
  ASSERT_EQ(states.size(), 1u);
  EXPECT_EQ(states[0].at("flow"), "steady");
  EXPECT_FALSE(summary.contains("season"));
  EXPECT_NEAR(find_pond(states[0]), 17, 1e-9);
  // The pool begins where the face, 2.5:1 from (22, 20), is as high as it.
  double left = 70;
  for (const json& pond : states[0].at("ponds")) left = std::min(left, pond.at("from")[0].get<double>());
  EXPECT_NEAR(left, 22 + 2.5 * 3, 1e-6);
  EXPECT_NEAR(find_table(states[0], 1), 17.5, 0.05);
}

}  // namespace
}  // namespace talus
