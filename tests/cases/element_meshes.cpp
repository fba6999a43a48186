// SPDX-License-Identifier: MIT
// [fem] meshes = 2: the factor is that of two runs on one mesh each, extrapolated to elements of no size.

#include "base/extrapolate.hpp"
#include "cases/methods_slope.hpp"

namespace talus {
namespace {

class ElementMeshes : public MethodsTest {};

TEST_F(ElementMeshes, TwoMeshesExtrapolateTwoRuns) {
  const std::string text = write_case("\"fem\"", "[fem]\nsize = 4\nresolution = 0.02\n");
  const auto find = [&](const std::vector<input::Override>& overrides) {
    return run(text, overrides).at("fem").at("runs").at(0);
  };
  const auto both = find({{"fem.meshes", "2"}}), coarse = find({}), fine = find({{"fem.size", "2"}});
  const auto& meshes = both.at("meshes");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].at("factor"), coarse.at("factor"));
  EXPECT_EQ(meshes[1].at("factor"), fine.at("factor"));
  EXPECT_FALSE(coarse.contains("meshes"));
  const double expected = extrapolate_to_zero(meshes[0].at("size").get<double>(), coarse.at("factor").get<double>(),
                                              meshes[1].at("size").get<double>(), fine.at("factor").get<double>());
  EXPECT_NEAR(both.at("factor").get<double>(), expected, 1e-12);
  EXPECT_NEAR(meshes[0].at("size").get<double>() / meshes[1].at("size").get<double>(), 2, 0.3);
}

}  // namespace
}  // namespace talus
