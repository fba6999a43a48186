// SPDX-License-Identifier: MIT
// [lem.drawdown], the envelopes and B̄ of its soils, and the keys that it excludes.

#include <cmath>

#include "methods_slope.hpp"

namespace talus::input {
namespace {

const std::string envelope = "[materials.soil.undrained_envelope]\ncohesion = \"1200 psf\"\nfriction_angle = 16\n";
const std::string water = "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 34]]\n";
const std::string after = "water_table = [[0, 26]]\n";
const std::string three_stages = "[lem.drawdown]\nmethod = \"three_stage\"\n" + after;
const std::string by_b_bar = "[lem.drawdown]\nmethod = \"b_bar\"\n" + after;
const std::string drawn = slices_alone + envelope + water;

TEST(Drawdown, ReadsItsKeys) {
  const Case data = read(drawn + three_stages);
  ASSERT_TRUE(data.lem.drawdown);
  EXPECT_EQ(data.lem.drawdown->method, DrawdownMethod::three_stage);
  EXPECT_EQ(data.lem.drawdown->water_table[0], (std::array{0.0, 26.0}));
  const SliceSoil& soil = data.materials.at("soil").slices;
  EXPECT_NEAR(soil.undrained_envelope->cohesion, 57456.3, 0.1);
  EXPECT_NEAR(soil.undrained_envelope->friction_angle, 16 * M_PI / 180, 1e-12);
  EXPECT_FALSE(soil.b_bar);
  EXPECT_FALSE(read(slices_alone).lem.drawdown);
  const Case inline_table = read(change(
      slices_alone, "friction_angle = 19.6\n",
      "friction_angle = 19.6\nundrained_envelope = { cohesion = 20, friction_angle = \"15 deg\" }\nb_bar = 0.9\n"));
  EXPECT_DOUBLE_EQ(inline_table.materials.at("soil").slices.undrained_envelope->cohesion, 20e3);
  EXPECT_DOUBLE_EQ(*inline_table.materials.at("soil").slices.b_bar, 0.9);
}

TEST(Drawdown, NeedsWaterThatFalls) {
  expect_fault(slices_alone + envelope + "@@" + three_stages, "there is no water to draw down");
  expect_fault(drawn + "[lem.drawdown]\nmethod = \"three_stage\"\nwater_table = @@[[0, 34.5]]\n",
               "At x = 0 m the water table after drawdown (34.5 m) is above the one before (34 m)");
  expect_fault(drawn + "[lem.drawdown]\nmethod = \"three_stage\"\nwater_table = @@[[0, 30], [90, 36]]\n",
               "At x = 90 m the water table after drawdown (36 m) is above");
  EXPECT_TRUE(find_faults(drawn + "[lem.drawdown]\nmethod = \"three_stage\"\nwater_table = [[0, 34]]\n").empty());
  expect_fault(drawn + "[lem.drawdown]\nmethod = \"three_stage\"\nwater_table = @@[]\n", "needs at least one point");
  expect_fault(drawn + "[lem.drawdown]\nmethod = \"three_stage\"\nwater_table = [[5, 20], @@[0, 20]]\n",
               "must run from left to right");
  expect_fault(drawn + "@@[lem.drawdown]\n" + after, "'method'");
}

TEST(Drawdown, NeedsASoilThatHoldsItsWater) {
  expect_fault(slices_alone + water + "[lem.drawdown]\nmethod = @@\"three_stage\"\n" + after,
               "needs a soil with an `undrained_envelope`");
  expect_fault(drawn + "[lem.drawdown]\nmethod = @@\"b_bar\"\n" + after, "needs a soil with a `b_bar`");
  EXPECT_TRUE(find_faults(change(slices_alone, "friction_angle = 19.6\n", "friction_angle = 19.6\nb_bar = 1\n") +
                          water + by_b_bar)
                  .empty());
  expect_fault(change(slices_alone, "friction_angle = 19.6\n", "friction_angle = 19.6\nb_bar = @@1.2\n"), "b_bar");
  expect_fault(change(slices_alone, "friction_angle = 19.6\n", "friction_angle = 0\n") + "@@" + envelope,
               "no friction angle in effective stresses");
}

TEST(Drawdown, ExcludesOtherMethods) {
  expect_fault(with_elements + envelope + water + "@@" + three_stages, "by LEM only");
  // Keys of a method that is not selected may stay.
  EXPECT_TRUE(find_faults(change(with_elements, "[\"lem\", \"fem\"]", "[\"fem\"]") + water + three_stages).empty());
  expect_fault(drawn + "[earthquake]\nhorizontal = 0.1\n@@" + three_stages, "not with [earthquake]");
  expect_fault(drawn + "[lem]\nyield_acceleration = @@true\n" + three_stages, "not with [lem.drawdown]");
  EXPECT_TRUE(find_faults(drawn + "[lem]\nyield_acceleration = false\n" + three_stages).empty());
  expect_fault(drawn + "[partial_factors]\nset = \"DA1-2\"\n@@" + three_stages, "not with [partial_factors]");
  expect_fault(drawn +
                   "[[study.random]]\nkey = \"materials.soil.cohesion\"\ndeviation = 1\n[study]\nmode = "
                   "\"sample\"\n@@" +
                   three_stages,
               "not with mode = \"sample\"");
}

TEST(Drawdown, DoesNotGoWithATimeline) {
  bool result = false;
  for (const Diagnostic& fault : find_faults(drawn + three_stages + "[timeline]\nduration = 3\n"))
    result = result || fault.sentence.find("not with [timeline]") != std::string::npos;
  EXPECT_TRUE(result);
}

}  // namespace
}  // namespace talus::input
