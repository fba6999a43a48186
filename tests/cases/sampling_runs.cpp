// SPDX-License-Identifier: MIT
// Samples that are runs of the case: runout of a collapsing column, factors by FEM, resumption.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cases/sampling_slope.hpp"
#include "results/json.hpp"
#include "study/sampling.hpp"

namespace talus::study {
namespace {

using nlohmann::json;

const std::string column = R"(
title = "Column"
[geometry]
box = [[0, 0], [4, 1.2]]
[[geometry.polygon]]
name = "column"
points = [[0, 0], [0.8, 0], [0.8, 0.8], [0, 0.8]]
[mesh]
size = 0.2
[materials.sand]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.4
young_modulus = "1 MPa"
poisson_ratio = 0.3
cohesion = 0
friction_angle = "30 deg"
dilatancy_angle = 0
tensile_strength = 0
[regions]
column = "sand"
[initial]
stress = "k0"
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[stage]]
name = "collapse"
duration = 1.2
damping = 0.05
[study]
mode = "sample"
method = "mpm"
samples = 8
runout = [0.05, 0.3]
[[study.random]]
key = "materials.sand.friction_angle"
distribution = "uniform"
lowest = "20 deg"
highest = "45 deg"
)";

SamplingResult run(const input::LoadedCase& base, const StudyOptions& options) {
  return run_sampling(base, {}, options);
}

TEST(SamplingRuns, RunoutIsExceededLessOftenTheFartherItIs) {
  const input::LoadedCase base = input::read_case_text(column, "column.toml");
  StudyOptions options;
  options.folder = sampling_slope::make_folder("column");
  options.threads = 2;
  const SamplingResult first = run(base, options);
  ASSERT_FALSE(first.failure) << first.failure->what();
  const json study = results::to_json(first.study);
  const json& block = study.at("sampling");
  const json& runout = block.at("runout");
  EXPECT_EQ(runout.at("count"), 8);
  EXPECT_GT(runout.at("largest").get<double>(), 0.3);
  EXPECT_LT(runout.at("largest").get<double>(), 3);
  EXPECT_LT(runout.at("ranks")[0].at("coefficient").get<double>(), -0.8);  // weaker sand comes farther
  double before = 1;
  for (const json& point : runout.at("curve")) {
    EXPECT_LE(point[1].get<double>(), before);
    EXPECT_LE(point[2].get<double>(), point[1].get<double>());
    EXPECT_GE(point[3].get<double>(), point[1].get<double>());
    before = point[1];
  }
  EXPECT_EQ(before, 0);  // nothing comes farther than the farthest
  EXPECT_EQ(runout.at("exceedance")[1].at("distance"), 0.3);
  EXPECT_EQ(runout.at("exceedance")[0].at("samples"), 8);
  EXPECT_TRUE(block.at("factor").is_null());  // a run alone has no factor of safety
  EXPECT_EQ(study.at("variants").size(), 9u);
  EXPECT_EQ(study.at("variants")[0].at("folder"), "means");

  // A study that lost some of its samples calculates those again, and keeps the others.
  std::filesystem::remove_all(options.folder / "sample_3");
  const auto kept = std::filesystem::last_write_time(options.folder / "sample_4" / "summary.json");
  options.resume = true;
  const SamplingResult again = run(base, options);
  json a = results::to_json(again.study).at("sampling"), b = block;
  a.erase("seconds");
  b.erase("seconds");
  EXPECT_EQ(a, b);
  EXPECT_EQ(std::filesystem::last_write_time(options.folder / "sample_4" / "summary.json"), kept);
}

TEST(SamplingRuns, FiniteElementsGiveAFactorOfEverySample) {
  const std::string text = sampling_slope::write_case(R"(
[study]
mode = "sample"
method = "fem"
samples = 3
[[study.random]]
key = "materials.soil.cohesion"
deviation = "5 kPa"
)");
  const std::vector<input::Override> changes{{"analysis.methods", R"(["lem", "fem"])"},
                                             {"materials.soil.young_modulus", "\"20 MPa\""},
                                             {"materials.soil.poisson_ratio", "0.3"},
                                             {"materials.soil.dilatancy_angle", "0"},
                                             {"materials.soil.tensile_strength", "0"},
                                             {"materials.soil.pore_pressure_ratio", "0"},
                                             {"fem.size", "2.5"},
                                             {"fem.flow", "associated"},
                                             {"fem.resolution", "0.02"}};
  const input::LoadedCase base = input::read_case_text(text, "li_lumb.toml", changes);
  StudyOptions options;
  options.folder = sampling_slope::make_folder("elements");
  const SamplingResult result = run_sampling(base, changes, options);
  ASSERT_FALSE(result.failure) << result.failure->what();
  const json block = results::to_json(result.study).at("sampling");
  EXPECT_EQ(block.at("factor").at("count"), 3);
  EXPECT_DOUBLE_EQ(block.at("ranks")[0].at("coefficient").get<double>(), 1);  // more cohesion, a larger factor
  EXPECT_GT(block.at("factor").at("mean").get<double>(), 1.3);
  EXPECT_LT(block.at("factor").at("mean").get<double>(), 1.9);
  EXPECT_TRUE(block.at("runout").is_null());
}

}  // namespace
}  // namespace talus::study
