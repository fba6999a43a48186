// SPDX-License-Identifier: MIT
// Limit analysis as the referee of LEM: a factor that is proven impossible never governs.

#include <fstream>
#include <iterator>

#include "cases/methods_slope.hpp"
#include "results/bounds.hpp"

namespace talus {
namespace {

using nlohmann::json;

class RefereeTest : public MethodsTest {
 protected:
  json run_file(const std::string& name, const std::vector<input::Override>& overrides = {}) {
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/" + name + ".toml");
    return run({std::istreambuf_iterator<char>(file), {}}, overrides);
  }

  static std::pair<double, double> read_interval(const json& summary, const char* method) {
    const json& bounds = std::string(method) == "lem" ? summary.at("lem").at("referee") : summary.at(method);
    if (!bounds.at("lower").is_number() || !bounds.at("upper").is_number()) {
      ADD_FAILURE() << bounds.dump();
      return {0, 0};
    }
    return {bounds.at("lower"), bounds.at("upper")};
  }

  static bool has_warning(const json& summary, const std::string& part) {
    for (const json& remark : summary.at("methods").at("remarks"))
      if (remark.at("text").get<std::string>().find(part) != std::string::npos) return true;
    return false;
  }
};

/// A strip load on clay without friction: (2 + π) c/q = 1.285 (Prandtl 1920). The best circle has 1.379.
TEST_F(RefereeTest, TheUpperBoundGovernsBeforeCirclesAboveIt) {
  const json summary =
      run_file("level_strip", {{"lem.methods", "[\"bishop\", \"spencer\"]"}, {"lem.noncircular", "false"}});
  constexpr double prandtl = (2 + 3.14159265358979) * 25 / 100;
  const auto [lower, upper] = read_interval(summary, "lem");
  EXPECT_LE(lower, prandtl);
  EXPECT_GE(upper, prandtl);
  EXPECT_GT(find_factor(summary, "spencer"), 1.05 * prandtl);
  EXPECT_EQ(summary.at("main_factor").get<double>(), upper);
  EXPECT_EQ(summary.at("lem").at("critical").at(0).at("verdict"), "above_upper_bound");
  EXPECT_TRUE(has_warning(summary, "above the upper bound"));
}

/// Rock that no slip surface enters is rigid for the referee too, whatever strength stands in the case.
TEST_F(RefereeTest, KnowsImpenetrableRock) {
  const json summary = run(R"(
analysis.methods = ["lem"]
geometry.polygon = [
  { name = "rock", points = [[0, 0], [60, 0], [60, 6], [0, 6]] },
  { name = "clay", points = [[0, 6], [60, 6], [60, 16], [48, 16], [32, 8], [0, 8]] }]
regions = { rock = "rock", clay = "clay" }
materials.clay = { model = "mohr_coulomb", unit_weight = 19, cohesion = 20, friction_angle = 0 }
materials.rock = { model = "mohr_coulomb", unit_weight = 22, cohesion = 20, friction_angle = 0 }
lem = { impenetrable = ["rock"], methods = ["spencer"], noncircular = false, minima = 1 }
)");
  const auto [lower, upper] = read_interval(summary, "lem");
  EXPECT_GE(upper, 0.98 * find_factor(summary, "spencer")) << "the proof is that of a section with a base at 6 m";
  EXPECT_NE(summary.at("lem").at("critical").at(0).value("verdict", ""), "above_upper_bound");
}

/// 60°: Spencer has no solution on Bishop's critical circle, and the least of the others has 1.326. Circles that end in
/// a tension crack take their place, and limit analysis decides.
TEST_F(RefereeTest, ASteepSlopeIsComparedOnCirclesWithACrack) {
  const json summary =
      run_file("steep_chart", {{"lem.methods", "[\"bishop\", \"spencer\"]"}, {"lem.noncircular", "false"}});
  const auto [lower, upper] = read_interval(summary, "lem");
  EXPECT_LT(find_factor(summary, "spencer"), upper);
  EXPECT_NE(summary.at("methods").dump().find("critical circle, tension crack of"), std::string::npos);
  EXPECT_GE(summary.at("main_factor").get<double>(), (1 - results::judging_tolerance) * lower - 1e-3);
  EXPECT_LE(summary.at("main_factor").get<double>(), upper);
}

/// The governing factor lies in the interval of limit analysis, which meets the narrower one of meshes of 3,000
/// triangles.
TEST_F(RefereeTest, WhatGovernsIsProvenPossible) {
  struct Slope {
    const char* name;
    double lower, upper;
  };
  for (const Slope& slope :
       {Slope{"bank_2to1", 1.385, 1.399}, {"clay_45", 1.521, 1.573}, {"flat_clay", 1.231, 1.262}}) {
    const json summary = run_file(
        slope.name, {{"analysis.methods", "[\"lem\"]"}, {"lem.methods", "[\"spencer\", \"morgenstern_price\"]"}});
    const auto [lower, upper] = read_interval(summary, "lem");
    EXPECT_LE(lower, slope.upper) << slope.name;
    EXPECT_GE(upper, slope.lower) << slope.name;
    EXPECT_LE(upper / lower - 1, 0.035) << slope.name;
    EXPECT_GE(summary.at("main_factor").get<double>(), (1 - results::judging_tolerance) * lower - 1e-3) << slope.name;
    EXPECT_LE(summary.at("main_factor").get<double>(), (1 + results::judging_tolerance) * upper + 1e-3) << slope.name;
  }
}

/// Ponded water on soil without tensile strength: before, 0.000 to 0.228.
TEST_F(RefereeTest, BoundsHoldUnderThePondOfADam) {
  const json summary =
      run_file("dam_pond", {{"analysis.methods", "[\"bounds\"]"}, {"bounds.gap", "0.08"}, {"bounds.size", "3"}});
  const auto [lower, upper] = read_interval(summary, "bounds");
  EXPECT_GT(lower, 1.42);
  EXPECT_LT(lower, 1.561);
  EXPECT_GT(upper, 1.515);
  EXPECT_LT(upper, 1.62);
}

/// Before, 0.000 to 2.017: the ends of the load lay inside edges.
TEST_F(RefereeTest, BoundsHoldUnderAStripBetweenTwoSoils) {
  const json summary = run_file("strip_two_soils");
  const auto [lower, upper] = read_interval(summary, "bounds");
  EXPECT_GT(lower, 1.85);
  EXPECT_LT(lower, 1.935);
  EXPECT_GT(upper, 1.888);
  EXPECT_LT(upper, 1.98);
}

/// The velocities of clay are moved until its volume is constant to rounding. Where that moved sand too, no mechanism
/// of a mesh passed its check, and the upper bound stayed at 1.119.
TEST_F(RefereeTest, SandOverClayKeepsItsFlowRule) {
  const auto [lower, upper] = read_interval(run_file("sand_over_clay"), "bounds");
  EXPECT_GE(lower, 0.995);
  EXPECT_LE(upper, 1.07);
}

TEST_F(RefereeTest, CanBeTurnedOffWithANote) {
  const json summary = run(write_case("\"lem\"", few_circles));
  EXPECT_FALSE(summary.at("lem").contains("referee"));
  EXPECT_TRUE(has_warning(summary, "referee = false"));
}

/// A load that ends inside an edge, on soil without tensile strength: LEM has 1.63 to 1.67.
TEST_F(RefereeTest, BoundsHoldUnderALoadOnPartOfTheCrest) {
  const json summary = run_file("crest_strip", {{"bounds.gap", "0.06"}});
  const auto [lower, upper] = read_interval(summary, "bounds");
  EXPECT_GT(lower, 1.55);
  EXPECT_LT(upper, 1.75);
}

/// Without tensile strength a submerged slope is a buoyant one.
TEST_F(RefereeTest, ASubmergedSlopeIsABuoyantOne) {
  const std::string rough = "[bounds]\ngap = 0.08\ntriangles = 700\nsize = 2.5\n";
  const std::vector<input::Override> cohesive{{"materials.sand.cohesion", "5"},
                                              {"materials.sand.tensile_strength", "0"}};
  const json wet = run(write_case("\"bounds\"", rough + "[initial]\npore_pressure = \"water_table\"\n"
                                                        "water_table = [[0, 18], [44, 18]]\n"),
                       cohesive);
  const auto [lower, upper] = read_interval(wet, "bounds");
  // 2650 kg/m³ of grains, 40 % of pores: 9.72 kN/m³ under water of 1000 kg/m³.
  std::vector<input::Override> dry = cohesive;
  dry.push_back({"materials.sand.grain_density", "1650"});
  const json buoyant = run(write_case("\"bounds\"", rough), dry);
  const auto [low, high] = read_interval(buoyant, "bounds");
  EXPECT_LE(lower, high);
  EXPECT_GE(upper, low);
  EXPECT_LE(upper / lower, 1.1);
  EXPECT_LE(high / low, 1.1);
}

/// The same suction throughout is a cohesion of s tan φ_b, in every method.
TEST_F(RefereeTest, SuctionByAngleIsTheCohesionThatItGives) {
  constexpr double suction = 10, cohesion = 5;  // kPa
  const std::string rough =
      "[bounds]\ngap = 0.08\ntriangles = 700\nsize = 2.5\n[fem]\nsize = 2.5\n[initial]\npore_pressure = "
      "\"water_table\"\n"
      "water_table = [[0, 0], [44, 0]]\nlargest_suction = " +
      fmt::format("\"{} kPa\"\n", suction);
  const auto run_with = [&](double c, const char* how) {  // tension up to the apex, c / tan 30°
    std::vector<input::Override> changes{
        {"materials.sand.cohesion", fmt::format("\"{} kPa\"", c)},
        {"materials.sand.suction_strength", how},
        {"materials.sand.tensile_strength", fmt::format("\"{} kPa\"", 0.9999 * c * std::sqrt(3.0))},
        {"lem.methods", "[\"bishop\"]"},
        {"lem.noncircular", "false"},
        {"lem.referee", "false"}};
    if (std::string(how) == "phi_b") changes.push_back({"materials.sand.phi_b", "15"});
    return run(write_case(R"("lem", "fem", "bounds")", rough), changes);
  };
  const json by_angle = run_with(cohesion, "phi_b"), none = run_with(cohesion, "none"),
             cohesive = run_with(cohesion + suction * std::tan(15 * 3.14159265358979 / 180), "none");
  const auto find_fem = [](const json& summary) {
    return summary.at("fem").at("runs").at(0).at("factor").get<double>();
  };
  EXPECT_NEAR(find_factor(by_angle, "bishop"), find_factor(cohesive, "bishop"), 1e-6);
  EXPECT_NEAR(find_fem(by_angle), find_fem(cohesive), 0.006);  // the bracket
  EXPECT_GT(find_fem(by_angle), find_fem(none) + 0.05);
  const auto [lower, upper] = read_interval(by_angle, "bounds");
  const auto [low, high] = read_interval(cohesive, "bounds");
  EXPECT_NEAR(lower, low, 0.02);
  EXPECT_NEAR(upper, high, 0.02);
}

/// A rigid footing bears no less on its strength: 10⁵ and 10⁶ kPa give one interval.
TEST_F(RefereeTest, AStrongBlockIsAsStrongAsItNeedsToBe) {
  std::vector<std::pair<double, double>> intervals;
  for (const char* cohesion : {"1e5", "1e6"}) {
    const json summary = run_file(
        "rough_footing", {{"materials.steel.cohesion", cohesion}, {"bounds.gap", "0.3"}, {"bounds.triangles", "700"}});
    intervals.push_back(read_interval(summary, "bounds"));
  }
  EXPECT_NEAR(intervals[0].first, intervals[1].first, 1e-3);
  EXPECT_NEAR(intervals[0].second, intervals[1].second, 1e-3);
}

/// N_γ = 2.8389 of a rough footing at 20° (Martin 2005) makes the load the exact one.
TEST_F(RefereeTest, BoundsHoldTheBearingCapacityOfSand) {
  const json summary = run_file("rough_footing", {{"bounds.gap", "0.06"}, {"bounds.triangles", "2000"}});
  const auto [lower, upper] = read_interval(summary, "bounds");
  EXPECT_GE(lower, 0.95);
  EXPECT_LE(lower, 1.0);
  EXPECT_GE(upper, 1.0);
  EXPECT_LE(upper, 1.05);
}

}  // namespace
}  // namespace talus
