// SPDX-License-Identifier: MIT
// Combinations of keys that ruin a calculation are replaced, with a message that states what, where and why.

#include "input/read.hpp"
#include "wet_slope.hpp"

namespace talus::input {
namespace {

LoadedCase load(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_case_text(text, "slope.toml", overrides);
}

TEST(Harmful, StableSmoothingIsReplacedInTheTwoVelocityFormulation) {
  const LoadedCase loaded = load(wet_slope, {{"stage.0.smoothing", "stable"}, {"stage.0.water", "flows"}});
  ASSERT_EQ(loaded.warnings.size(), 1u);
  for (const char* part : {"stage '", "smoothing = \"stable\"", "water", "smoothing = \"none\" instead"})
    EXPECT_NE(loaded.warnings[0].sentence.find(part), std::string::npos) << part << ": " << loaded.warnings[0].sentence;
  EXPECT_EQ(loaded.data.stages[0].step.smoothing, Smoothing::none);
  EXPECT_TRUE(load(wet_slope, {{"stage.0.smoothing", "strain"}, {"stage.0.water", "flows"}}).warnings.empty());
  EXPECT_TRUE(load(wet_slope, {{"stage.0.smoothing", "stable"}}).warnings.empty()) << "it seeps";
  EXPECT_TRUE(
      load(wet_slope, {{"stage.0.smoothing", "stable"}, {"stage.0.geometry", "frozen"}, {"stage.0.water", "held"}})
          .warnings.empty());
  EXPECT_TRUE(load(slope, {{"stage.0.smoothing", "stable"}}).warnings.empty()) << "dry soil";
}

TEST(Harmful, PlainSmoothingOfDilatantSoilIsReplacedByTheStableForm) {
  EXPECT_TRUE(
      load(slope, {{"stage.failure.smoothing", "strain"}, {"materials.sand.dilatancy_angle", "0"}}).warnings.empty());
  const LoadedCase loaded =
      load(slope, {{"stage.failure.smoothing", "strain"}, {"materials.sand.dilatancy_angle", "10"}});
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].sentence.find("dilates"), std::string::npos) << loaded.warnings[0].sentence;
  EXPECT_EQ(loaded.data.stages[1].step.smoothing, Smoothing::stable);
}

TEST(Harmful, PressuresWithoutWaterAreConstantAtFrozenGeometry) {
  for (const std::vector<Override>& held :
       {std::vector<Override>{{"materials.sand.pore_pressure_ratio", "0.2"}},
        {{"initial.pore_pressure", "water_table"}, {"initial.water_table", "[[0, 8], [44, 4]]"}}}) {
    const LoadedCase loaded = load(slope, held);
    ASSERT_EQ(loaded.warnings.size(), 1u) << "one sentence for all stages";
    EXPECT_NE(loaded.warnings[0].sentence.find("stage 'gravity', stage 'failure'"), std::string::npos)
        << loaded.warnings[0].sentence;
    for (const Stage& stage : loaded.data.stages) EXPECT_EQ(stage.step.geometry, Geometry::frozen);
  }
  EXPECT_TRUE(load(slope).warnings.empty());
}

}  // namespace
}  // namespace talus::input
