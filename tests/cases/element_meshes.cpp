// SPDX-License-Identifier: MIT
// [fem] meshes: with two, the factor is extrapolated from the runs on each of them to zero element size and has an
// interval; with one there is no interval. [fem] adapt: the meshes are refined where the soil shears.

#include "base/extrapolate.hpp"
#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class ElementMeshes : public MethodsTest {
 protected:
  const std::string text_ = write_case("\"fem\"", "[fem]\nsize = 2\nresolution = 0.02\n");

  /// The remarks on FEM, one after the other.
  static std::string join_remarks(const json& summary) {
    std::string all;
    for (const json& remark : summary.at("methods").at("remarks")) all += remark.at("text").get<std::string>() + "\n";
    return all;
  }
};

TEST_F(ElementMeshes, TwoMeshesAreTheDefaultAndExtrapolateTwoRuns) {
  const auto find = [&](const std::vector<input::Override>& overrides) {
    return run(text_, overrides).at("fem").at("runs").at(0);
  };
  const json both = find({}), fine = find({{"fem.meshes", "1"}}),
             coarse = find({{"fem.meshes", "1"}, {"fem.size", "4"}});
  const json& meshes = both.at("meshes");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].at("factor"), coarse.at("factor"));
  EXPECT_EQ(meshes[1].at("factor"), fine.at("factor"));
  const double expected = extrapolate_to_zero(meshes[0].at("size").get<double>(), coarse.at("factor").get<double>(),
                                              meshes[1].at("size").get<double>(), fine.at("factor").get<double>());
  EXPECT_NEAR(both.at("factor").get<double>(), expected, 1e-12);
  EXPECT_NEAR(meshes[0].at("size").get<double>() / meshes[1].at("size").get<double>(), 2, 0.3);
  const double lower = both.at("interval").at("lower"), upper = both.at("interval").at("upper");
  EXPECT_LT(lower, expected);
  EXPECT_GE(upper, fine.at("failed").get<double>());
}

TEST_F(ElementMeshes, IntervalOfAssociatedFlowHoldsTheFactorOfSpencersCircle) {
  const json summary = run(text_, {{"fem.flow", "associated"}, {"fem.size", "1"}, {"fem.resolution", "0.005"}});
  const json& interval = summary.at("fem").at("runs").at(0).at("interval");
  EXPECT_LE(interval.at("lower").get<double>(), 1.439);
  EXPECT_GE(interval.at("upper").get<double>(), 1.439);
  const json& row = summary.at("methods").at("table").at(0);
  EXPECT_EQ(row.at("lower"), interval.at("lower"));
  EXPECT_EQ(row.at("upper"), interval.at("upper"));
  EXPECT_NE(join_remarks(summary).find("the interval of mesh and search"), std::string::npos);
}

TEST_F(ElementMeshes, AdaptedMeshesHaveANarrowIntervalThatMeetsThatOfLimitAnalysis) {
  const json summary =
      run(text_, {{"fem.flow", "associated"}, {"fem.adapt", "true"}, {"fem.size", "1.5"}, {"fem.resolution", "0.005"}});
  const json& fem = summary.at("fem");
  const json& found = fem.at("runs").at(0);
  const json &meshes = found.at("meshes"), &interval = found.at("interval");
  ASSERT_GE(meshes.size(), 3u);
  const json &coarse = meshes[meshes.size() - 2], &fine = meshes.back();
  EXPECT_NEAR(found.at("factor").get<double>(),
              extrapolate_to_zero(coarse.at("size"), coarse.at("factor"), fine.at("size"), fine.at("factor")), 1e-12);
  const double lower = interval.at("lower"), upper = interval.at("upper");
  EXPECT_LE(lower, 1.4572) << "the upper bound of limit analysis";
  EXPECT_GE(upper, 1.4309) << "its lower bound";
  EXPECT_LT(upper - lower, 0.05 * upper);
  EXPECT_EQ(found.at("stable"), fine.at("stable"));
  EXPECT_LT(fine.at("size").get<double>(), 0.7 * fem.at("size").get<double>()) << "finest where the soil shears";
}

TEST_F(ElementMeshes, CasesThatAreNotAdaptedKeepTwoMeshesAndSayWhy) {
  const json summary = run(text_, {{"fem.flow", "both"}, {"fem.adapt", "true"}, {"fem.size", "4"}});
  EXPECT_NE(summary.at("warnings").dump().find("the mesh is not adapted: both flow rules share one mesh"),
            std::string::npos)
      << summary.at("warnings");
  for (const json& found : summary.at("fem").at("runs")) EXPECT_EQ(found.at("meshes").size(), 2u);
}

TEST_F(ElementMeshes, OneMeshHasNoInterval) {
  const json summary = run(text_, {{"fem.meshes", "1"}});
  const json& found = summary.at("fem").at("runs").at(0);
  EXPECT_FALSE(found.contains("meshes"));
  EXPECT_FALSE(found.contains("interval"));
  const json& row = summary.at("methods").at("table").at(0);
  EXPECT_TRUE(row.at("lower").is_null()) << "the bracket of the search is no interval of the factor";
  EXPECT_TRUE(row.at("upper").is_null());
  EXPECT_NE(join_remarks(summary).find("one mesh: the mesh error is not known"), std::string::npos);
}

TEST_F(ElementMeshes, SoilThatSoftensNeedsANonlocalLengthOfTwoElements) {
  const auto search = [&](const std::string& length) {
    std::vector<input::Override> soft{
        {"materials.sand.model", "\"softening_mohr_coulomb\""}, {"materials.sand.residual_cohesion", "1"},
        {"materials.sand.residual_friction_angle", "20"},       {"materials.sand.softening_end", "0.02"},
        {"materials.sand.limit_strength", "\"peak\""},          {"fem.softening", "\"progressive\""}};
    if (!length.empty()) soft.push_back({"mesh.softening_length", length});
    return run(text_, soft);
  };
  const auto warns = [](const json& summary, const char* words) {
    return summary.at("warnings").dump().find(words) != std::string::npos;
  };
  const json own = search("");
  EXPECT_FALSE(own.at("fem").at("runs").at(0).contains("meshes")) << "the factor has no limit for small elements";
  EXPECT_TRUE(warns(own, "has no nonlocal length")) << own.at("warnings");
  const json sound = search("10"), narrow = search("3");
  EXPECT_EQ(sound.at("fem").at("runs").at(0).at("meshes").size(), 2u);
  EXPECT_FALSE(warns(sound, "must be at least twice that")) << sound.at("warnings");
  EXPECT_TRUE(warns(narrow, "must be at least twice that")) << narrow.at("warnings");
}

}  // namespace
}  // namespace talus
