// SPDX-License-Identifier: MIT
// LEM and FEM from one case file: the slope of the source, exchanged slip surfaces, stored results, and rejected input.

#include <cmath>
#include <fstream>

#include "base/progress.hpp"
#include "cases/methods_slope.hpp"
#include "support/run_json.hpp"

namespace talus {
namespace {

using nlohmann::json;

TEST_F(MethodsTest, SlicesGiveTheFactorsOfTable32) {
  // Slide2 in Table 3.2 of the source; an independent program found 1.440, 1.439, 1.439 and 1.386.
  const json summary = run(write_case("\"lem\"",
                                      "[lem]\nmethods = [\"bishop\", \"janbu\", \"spencer\", \"morgenstern_price\"]\n"
                                      "noncircular = false\n"));
  EXPECT_EQ(summary.at("status"), "finished");
  EXPECT_NEAR(find_factor(summary, "bishop"), 1.440, 0.005);
  EXPECT_NEAR(find_factor(summary, "spencer"), 1.439, 0.005);
  EXPECT_NEAR(find_factor(summary, "morgenstern_price"), 1.439, 0.005);
  EXPECT_NEAR(find_factor(summary, "janbu"), 1.386, 0.01);
  // The same numbers under the names that [[compare]] uses.
  EXPECT_EQ(support::find_result(summary, "lem.bishop"), find_factor(summary, "bishop"));
  EXPECT_TRUE(support::find_result(summary, "lem.yield_acceleration.spencer").has_value());
}

TEST_F(MethodsTest, ASlopeThatFacesLeftOrIsGivenInPartsHasTheSameFactor) {
  const std::string text = write_case("\"lem\"", few_circles);
  const double right = find_factor(run(text), "spencer");
  const std::string mirrored = "[[0, 0], [44, 0], [44, 15], [32, 15], [12, 5], [0, 5]]";
  EXPECT_NEAR(find_factor(run(text, {{"geometry.polygon.soil.points", mirrored}}), "spencer"), right, 1e-6);

  // Two polygons of one soil that overlap, the second a lens in the first, have the ground of the one.
  const std::string lens = "[[geometry.polygon]]\nname = \"lens\"\npoints = [[10, 2], [30, 2], [30, 4], [10, 4]]\n";
  EXPECT_NEAR(find_factor(run(text + lens, {{"regions.lens", "sand"}}), "spencer"), right, 1e-3);
}

TEST_F(MethodsTest, FemIsListedBesideLemAndLemIsEvaluatedOnItsBand) {
  const json summary = run(write_case("\"lem\", \"fem\"", std::string(few_circles) + R"(
[fem]
size = 1.5
flow = "associated"
resolution = 0.02
)"));
  const double spencer = find_factor(summary, "spencer");
  const json& fem = summary.at("fem").at("runs").at(0);
  EXPECT_NEAR(fem.at("factor").get<double>(), spencer, 0.03 * spencer);
  EXPECT_LE(fem.at("interval").at("lower").get<double>(), fem.at("factor").get<double>());
  EXPECT_GE(fem.at("interval").at("upper").get<double>(), fem.at("factor").get<double>());
  EXPECT_FALSE(fem.at("slip_line").empty());
  // Spencer's own circle is the weakest, and the factor of the band is a little larger.
  const auto handed = support::find_result(summary, "lem.handed[fem.associated.band].spencer");
  ASSERT_TRUE(handed.has_value());
  EXPECT_GT(*handed, 0.985 * spencer);
  EXPECT_LT(*handed, 1.08 * spencer);
  // Polylines are freer than circles: the surface optimised from the band is not above the band itself.
  const auto best = support::find_result(summary, "lem.handed[fem.associated.band].spencer_optimised");
  ASSERT_TRUE(best.has_value());
  EXPECT_LE(*best, *handed + 1e-6);
  EXPECT_FALSE(summary.at("methods").at("remarks").empty());
  for (const char* file : {"summary.json", "lem.json", "fem.json"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / file)) << file;
}

TEST_F(MethodsTest, ResumeKeepsWhatIsDone) {
  const std::string text = write_case("\"lem\"", few_circles);
  run(text);
  // The state of a run that was stopped after LEM; the file shows whether LEM was calculated again.
  json kept = json::parse(std::ifstream(folder_ / "lem.json"));
  kept["summary"]["seconds"] = 12345.0;
  leave("lem.json", kept);
  EXPECT_EQ(run(text, {}, true).at("lem").at("seconds"), 12345.0);
  // Nothing is kept of another input.
  leave("lem.json", kept);
  EXPECT_NE(run(text, {{"materials.sand.cohesion", "\"3 kPa\""}}, true).at("lem").at("seconds"), 12345.0);
}

TEST_F(MethodsTest, AnInterruptedRunResumesWithTheRemainingFlowRule) {
  const std::string text = write_case("\"lem\", \"fem\"", std::string(few_circles) + R"(
[fem]
size = 3
flow = "both"
resolution = 0.1
)");
  const json whole = run(text);
  // As after Ctrl-C between the two flow rules.
  json kept = json::parse(std::ifstream(folder_ / "fem.json"));
  ASSERT_EQ(kept.at("summary").at("runs").size(), 2u);
  kept["summary"]["runs"].erase(1);
  kept["runs"].erase(1);
  kept["summary"]["runs"][0]["seconds"] = 54321.0;
  leave("fem.json", kept);
  const json again = run(text, {}, true);
  ASSERT_EQ(again.at("fem").at("runs").size(), 2u);
  EXPECT_EQ(again.at("fem").at("runs").at(0).at("seconds"), 54321.0);
  EXPECT_EQ(again.at("fem").at("runs").at(1).at("factor"), whole.at("fem").at("runs").at(1).at("factor"));
  EXPECT_EQ(json::parse(std::ifstream(folder_ / "fem.json")).at("runs").size(), 2u);

  // After Ctrl-C the results of LEM are there, and the status is that of an interruption.
  request_interrupt();
  EXPECT_THROW(run(text), Error);
  request_interrupt(false);
  const json stopped = json::parse(std::ifstream(folder_ / "summary.json"));
  EXPECT_EQ(stopped.at("status"), "interrupted");
  EXPECT_FALSE(stopped.at("lem").at("critical").empty());
  EXPECT_EQ(run(text, {}, true).at("status"), "finished");
}

TEST_F(MethodsTest, CohesionThatGrowsWithDepthActsInBoth) {
  // Undrained clay: without growth and with 2 kPa/m from the crest down both methods rise, and stay together.
  const auto find = [&](double gradient) {
    const json summary = run(write_case("\"lem\", \"fem\"", few_circles),
                             {{"fem.size", "2"},
                              {"fem.resolution", "0.02"},
                              {"materials.sand.cohesion", "30"},
                              {"materials.sand.friction_angle", "0"},
                              {"materials.sand.cohesion_level", "15"},
                              {"materials.sand.cohesion_gradient", std::to_string(gradient)},
                              {"materials.sand.tensile_strength", "1000"}});
    return std::pair{find_factor(summary, "bishop"), summary.at("fem").at("runs").at(0).at("factor").get<double>()};
  };
  const auto even = find(0), growing = find(2);
  EXPECT_GT(growing.first, 1.15 * even.first);
  EXPECT_NEAR(even.second, even.first, 0.06 * even.first);
  EXPECT_NEAR(growing.second, growing.first, 0.06 * growing.first);
}

TEST_F(MethodsTest, AFinishedRunIsReadBackAndComparedAnew) {
  const std::string text = write_case("\"lem\"", few_circles);
  const json first = run(text);
  const json again =
      run(text + "[[compare]]\nname = \"lem.bishop\"\nvalue = 1.44\ntolerance = 0.02\nsource = \"x\"\n", {}, true);
  EXPECT_EQ(again.at("timing"), first.at("timing"));
  ASSERT_EQ(again.at("comparisons").size(), 1u);
  EXPECT_TRUE(again.at("comparisons").at(0).at("passes").get<bool>());
}

TEST_F(MethodsTest, GivenSurfacesAreCutAsTheyAre) {
  // Bishop's critical circle by an independent program, cut off at the toe: 1.440.
  const json summary = run(write_case("\"lem\"", R"([lem]
methods = ["bishop", "spencer"]
search = "none"
[[lem.surface]]
name = "known"
centre = [35.04, 38.15]
radius = 33.29
ends = [11.12, 32]
)"));
  EXPECT_NEAR(support::find_result(summary, "lem.surface[known].bishop").value_or(0), 1.440, 0.004);
  EXPECT_TRUE(summary.at("lem").at("critical").empty());
}

TEST_F(MethodsTest, FaultsAreSentencesThatNameTheCulprit) {
  const std::string overhang = "[[0, 0], [44, 0], [44, 5], [32, 5], [34, 8], [12, 15], [0, 15]]";
  EXPECT_NE(find_fault(write_case("\"lem\"", few_circles), {{"geometry.polygon.soil.points", overhang}})
                .find("overhang, or in a cavity, of 3 m² from (32, 5) to (34, 8), around (33, "),
            std::string::npos);
  EXPECT_NE(find_fault(write_case("\"lem\"", std::string(few_circles) + R"(
[[lem.surface]]
name = "in the air"
centre = [20, 60]
radius = 5
)"))
                .find("in the air"),
            std::string::npos);
  const std::string deep = find_fault(write_case("\"lem\"", "[lem]\nsmallest_depth = 40\nnoncircular = false\n"));
  EXPECT_NE(deep.find("no admissible slip surface"), std::string::npos) << deep;
}

}  // namespace
}  // namespace talus
