// SPDX-License-Identifier: MIT
// Earthquakes act in both directions: each method computes both, and the lower factor governs.

#include <algorithm>
#include <fstream>
#include <iterator>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class EarthquakeTest : public MethodsTest {
 protected:
  json run_embankment(const std::vector<input::Override>& overrides) {
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/two_sided_quake.toml");
    return run({std::istreambuf_iterator<char>(file), {}}, overrides);
  }
};

/// The embankment's weak face looks to smaller x, both ends are equally high, and before, the earthquake acted towards
/// larger x alone: "at least 1.624 (lower bound)".
TEST_F(EarthquakeTest, FiniteElementsAndLimitAnalysisFindTheWeakSide) {
  const json both = run_embankment({{"analysis.methods", "[\"fem\", \"bounds\"]"},
                                    {"fem.flow", "\"associated\""},
                                    {"fem.size", "2"},
                                    {"fem.meshes", "1"},
                                    {"bounds.gap", "0.15"},
                                    {"bounds.triangles", "800"}});
  const json& elements = both.at("fem").at("runs").at(0);
  EXPECT_NEAR(elements.at("factor").get<double>(), 0.95, 0.04);
  EXPECT_EQ(elements.at("earthquake").at("direction"), -1);
  EXPECT_GT(elements.at("earthquake").at("other_stable").get<double>(), elements.at("factor").get<double>());
  const json& bounds = both.at("bounds");
  EXPECT_LE(bounds.at("lower").get<double>(), 0.933);
  EXPECT_GE(bounds.at("upper").get<double>(), 0.892);
  EXPECT_LE(bounds.at("upper").get<double>(), 1.1);
  EXPECT_EQ(bounds.at("earthquake").at("direction"), -1);
}

/// The dry slope fails towards larger x.
TEST_F(EarthquakeTest, MpmUsesTheDirectionWithTheLowerFactorAndReportsIt) {
  std::ifstream file(TALUS_SOURCE_DIR "/examples/dry_slope/case.toml");
  const json summary =
      run({std::istreambuf_iterator<char>(file), {}}, {{"earthquake.horizontal", "0.1"},
                                                       {"mesh.size", "3"},
                                                       {"strength_reduction.curve.step", "0.5"},
                                                       {"strength_reduction.curve.refine", "false"},
                                                       {"strength_reduction.curve.window", "1"},
                                                       {"strength_reduction.curve.runout", "[]"},
                                                       {"strength_reduction.frozen.meshes", "1"},
                                                       {"strength_reduction.frozen.resolution", "0.2"}});
  EXPECT_NE(summary.at("warnings").dump().find("takes the earthquake towards larger x"), std::string::npos);
}

/// The direction of the case is the only one, with the sign of the acceleration.
TEST_F(EarthquakeTest, ADirectionCanBeGiven) {
  const std::vector<input::Override> circles{{"analysis.methods", "[\"lem\"]"},
                                             {"lem.methods", "[\"bishop\", \"spencer\"]"},
                                             {"lem.noncircular", "false"},
                                             {"lem.referee", "false"}};
  const auto find = [&](const char* direction, const char* horizontal) {
    auto overrides = circles;
    overrides.push_back({"earthquake.direction", direction});
    overrides.push_back({"earthquake.horizontal", horizontal});
    return find_factor(run_embankment(overrides), "spencer");
  };
  const double both = find("\"both\"", "0.2"), left = find("\"left\"", "0.2"), right = find("\"right\"", "0.2");
  EXPECT_DOUBLE_EQ(both, std::min(left, right));
  EXPECT_LT(left, right);
  EXPECT_DOUBLE_EQ(find("\"both\"", "-0.2"), both);
  EXPECT_DOUBLE_EQ(find("\"right\"", "-0.2"), left);
  EXPECT_GT(right, find("\"both\"", "0"));
}

}  // namespace
}  // namespace talus
