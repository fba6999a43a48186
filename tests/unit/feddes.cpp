// SPDX-License-Identifier: MIT
// Feddes' reduction against its definition, in doubles and packs, and its slope against finite differences.

#include <gtest/gtest.h>

#include <cmath>

#include "material/water/feddes.hpp"

namespace talus {
namespace {

using material::Feddes;

TEST(Feddes, IsATrapezium) {
  const Feddes law{{1e3, 3e3, 40e3, 240e3}};
  const struct {
    double suction, fraction;
  } points[] = {{-5e3, 0}, {0, 0},       {1e3, 0},      {1.5e3, 0.25}, {3e3, 1}, {20e3, 1},
                {40e3, 1}, {90e3, 0.75}, {190e3, 0.25}, {240e3, 0},    {1e9, 0}};
  for (const auto& [suction, fraction] : points) {
    EXPECT_NEAR(law.evaluate(suction).value, fraction, 1e-14) << suction;
    const auto lanes = law.evaluate(Pack(suction));
    for (int l = 0; l < lane_width; ++l) {
      EXPECT_EQ(lanes.value.value[l], law.evaluate(suction).value);
      EXPECT_EQ(lanes.slope.value[l], law.evaluate(suction).slope);
    }
  }
}

TEST(Feddes, SlopeIsThatOfTheCurve) {
  const Feddes law{{1e3, 3e3, 40e3, 240e3}};
  for (double s = -950; s < 300e3; s += 137.7) {
    const double difference = law.evaluate(s + 0.5).value - law.evaluate(s - 0.5).value;
    bool corner = false;
    for (double c : law.suctions) corner = corner || std::abs(s - c) < 1;
    if (corner) continue;
    EXPECT_NEAR(law.evaluate(s).slope, difference, 1e-12) << s;
  }
}

TEST(Feddes, TwoEqualSuctionsLeaveWetSoilUnreduced) {
  const Feddes law{{0, 0, 40e3, 240e3}};
  for (double s : {-20e3, -1.0, 0.0, 1.0, 30e3}) {
    EXPECT_EQ(law.evaluate(s).value, 1) << s;
    EXPECT_EQ(law.evaluate(s).slope, 0) << s;
  }
  EXPECT_NEAR(law.evaluate(140e3).value, 0.5, 1e-14);
}

}  // namespace
}  // namespace talus
