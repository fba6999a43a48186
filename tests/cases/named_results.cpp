// SPDX-License-Identifier: MIT
// Results under the names of [[compare]]: values from the summary, tolerances, and the time of failure.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

#include "input/case/compare.hpp"
#include "run/mpm/record/motion.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const results::RunResult summary = support::to_run(json::parse(R"({
  "curve": {"points": [{"srf": 1.0, "displacement": 0.0}, {"srf": 1.4, "displacement": 0.016},
                       {"srf": 1.5, "displacement": 0.066}]},
  "factor_of_safety": {"value": 1.39, "frozen": {"factor": 1.39}, "criteria": [{"name": "bilinear", "factor": 1.58},
                       {"name": "jump", "factor": null}]},
  "stages": [{"name": "real strength", "displacement": 0.001, "time": 20.0, "end": "time"}],
  "runouts": [{"srf": 1.75, "end": "rest", "time": 8.2, "failure_time": 0.88, "runout": {"moved_volume": 91.3}}]
})"));

TEST(NamedResults, AreFoundWhereTheSummaryHoldsThem) {
  EXPECT_EQ(find_result(summary, "factor_of_safety"), 1.39);
  EXPECT_EQ(find_result(summary, "factor_of_safety.bilinear"), 1.58);
  EXPECT_EQ(find_result(summary, "factor_of_safety.jump"), std::nullopt);
  EXPECT_EQ(find_result(summary, "stage[real strength].displacement"), 0.001);
  EXPECT_EQ(find_result(summary, "runout[1.75].moved_volume"), 91.3);
  EXPECT_EQ(find_result(summary, "runout[1.75].failure_time"), 0.88);
  EXPECT_EQ(find_result(summary, "runout[1.75].rest_time"), 8.2);
  EXPECT_EQ(find_result(summary, "runout[1.6].rest_time"), std::nullopt);
}

TEST(NamedResults, AreInterpolatedBetweenTrials) {
  EXPECT_EQ(find_result(summary, "curve.displacement[1.4]"), 0.016);
  EXPECT_DOUBLE_EQ(*find_result(summary, "curve.displacement[1.45]"), 0.041);
  EXPECT_EQ(find_result(summary, "curve.displacement[1.6]"), std::nullopt);
}

TEST(Comparison, PassesWithinItsToleranceAndNotBeyond) {
  input::Case data;
  data.analysis = input::AnalysisKind::strength_reduction;
  const auto add = [&](const char* name, input::Amount value, input::Amount tolerance) {
    data.compare.push_back({name, value, tolerance, "by hand"});
  };
  add("factor_of_safety", {1.36, "", "1.36"}, {0.03, "", "0.03"});
  add("factor_of_safety", {1.36, "", "1.36"}, {0.029, "", "0.029"});
  add("curve.displacement[1.4]", {17, "mm", "17 mm"}, {6, "%", "6 %"});
  add("factor_of_safety.jump", {1.6, "", "1.6"}, {10, "%", "10 %"});
  add("curve.displacement[1.45]", {41, "mm", "41 mm"}, {6, "%", "6 %"});
  const std::vector<results::Comparison> list = compare_results(data, summary);
  ASSERT_EQ(list.size(), 5u);
  EXPECT_TRUE(list[0].passes);
  EXPECT_FALSE(list[1].passes);
  EXPECT_TRUE(list[2].passes);
  EXPECT_DOUBLE_EQ(list[2].published, 0.017);
  EXPECT_EQ(list[2].unit.name, "mm");
  EXPECT_FALSE(list[3].passes);
  EXPECT_FALSE(list[3].computed);
  EXPECT_EQ(list[2].note, "");
  EXPECT_EQ(list[4].note, "no trial at SRF 1.45: interpolated between those at 1.4 and 1.5");
}

TEST(FailureTime, IsTheLastCrossingOfTheLimit) {
  const fs::path file = support::name_scratch("onset.csv");
  // A stage settles by 40 mm, displacements start from zero, and the slope fails between 3 s and 4 s.
  std::ofstream(file) << "time [s],largest_displacement [mm]\n0,0\n1,40\n2,0\n3,10\n4,50\n5,900\n";
  const auto time = find_failure_time(file, 0.03);
  ASSERT_TRUE(time);
  EXPECT_DOUBLE_EQ(*time, 3.5);
  EXPECT_FALSE(find_failure_time(file, 1.0)) << "it never moved that far";
  fs::remove(file);
  EXPECT_FALSE(find_failure_time(file, 0.03));
}

}  // namespace
}  // namespace talus::run
