// SPDX-License-Identifier: MIT
// Retention curves against closed-form values, finite differences and limits, and packs against doubles.

#include "material/water/retention.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"

namespace talus::material {
namespace {

const std::vector<std::array<double, 2>> measured = {{500, 0.98}, {2e3, 0.9}, {10e3, 0.55}, {50e3, 0.3}, {400e3, 0.12}};

const std::vector<Retention> curves = {
    VanGenuchten{0.15, 1.0, 6130, 0.27},
    VanGenuchten{0.0, 0.95, 15630, 0.6},
    LinearRetention::from_scale(0.2, 1.0, 30e3),
    LinearRetention{0.0, 0.9, 2e-6},
    ExponentialRetention{0.06 / 0.4, 1.0, 0.1 / 98.1},
    make_retention_table(measured, Interpolation::linear),
    make_retention_table(measured, Interpolation::smooth),
};

TEST(LanePower, AgreesWithTheStandardLibrary) {
  std::mt19937_64 draw(3);
  std::uniform_real_distribution<double> exponent(-690, 690), power(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const double x = exponent(draw), e = std::exp(x), y = power(draw);
    EXPECT_NEAR(lane_exp(x) / e, 1, 5e-16 + 1.2e-16 * std::abs(x));  // exp itself carries the rounding of x ln2
    EXPECT_NEAR(lane_log(e), std::log(e), 5e-16 * std::abs(x));
    const double base = std::exp(x / 10);
    EXPECT_NEAR(lane_power(base, y) / std::pow(base, y), 1, 1e-15 + 3e-16 * std::abs(y * x / 10));
  }
  for (double x : {1.0, 1 + 1e-15, 1 - 1e-15, 1 + 1e-9, 0.70710678118654746, 0.70710678118654757, 1.4142135623730951})
    EXPECT_NEAR(lane_log(x), std::log(x), 2e-16 * std::abs(std::log(x))) << x;
  EXPECT_EQ(lane_exp(0.0), 1.0);
  EXPECT_EQ(lane_log(1.0), 0.0);
}

TEST(Retention, VanGenuchtenGivesTheSaturationAtTheCrestOfTheUnsaturatedSlope) {
  // Table 3.4: the suction of 56 kPa goes with 0.52 (section 3.4.2), computed independently as 0.5203.
  EXPECT_NEAR(saturation<double>(curves[0], 56e3), 0.5203, 5e-5);
  const double by_hand = 0.15 + 0.85 * std::pow(1 + std::pow(56e3 / 6130, 1 / 0.73), -0.27);
  EXPECT_NEAR(saturation<double>(curves[0], 56e3), by_hand, 1e-14);
  // at s = p_ref the bracket is 2
  EXPECT_NEAR(saturation<double>(curves[0], 6130), 0.15 + 0.85 * std::pow(2, -0.27), 1e-14);
}

TEST(Retention, TheOthersGiveTheirClosedValues) {
  EXPECT_NEAR(saturation<double>(curves[2], 15e3), 0.6, 1e-15);
  EXPECT_NEAR(saturation<double>(curves[2], 60e3), 0.2, 1e-15);
  EXPECT_NEAR(saturation<double>(curves[4], 2 * 98.1), 0.15 + 0.85 * std::exp(-0.2), 1e-14);
  EXPECT_NEAR(saturation<double>(curves[5], 6e3), 0.725, 1e-14);  // halfway between two pairs
  for (int t : {5, 6}) {
    for (const auto& pair : measured)
      EXPECT_NEAR(saturation<double>(curves[static_cast<std::size_t>(t)], pair[0]), pair[1], 1e-14);
  }
}

TEST(Retention, SlopesAreTheDifferencesAndNeverRise) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    double last = 2;
    for (double s = 3.7; s < 1e6; s *= 1.07) {
      const SoilWater<double> w = find_water(curves[c], s);
      const double h = 1e-5 * s, up = saturation(curves[c], s + h), down = saturation(curves[c], s - h);
      EXPECT_NEAR(w.slope, (up - down) / (2 * h), 2e-8 * std::abs(w.slope) + 1e-10 / s) << c << " at " << s;
      EXPECT_LE(w.slope, 0);
      EXPECT_LE(w.saturation, last);
      last = w.saturation;
    }
  }
}

TEST(Retention, LimitsAreKeptWhateverTheSuction) {
  for (const Retention& curve : curves) {
    const auto [low, high] = std::visit(
        [](const auto& c) {
          return std::array<double, 2>{c.minimum, c.maximum};
        },
        curve);
    for (double s : {-1e9, -5e3, -1e-300, 0.0}) {
      EXPECT_EQ(saturation(curve, s), high);
      EXPECT_EQ(find_water(curve, s).slope, 0);
      EXPECT_EQ(find_water(curve, s).effective, 1);
    }
    EXPECT_EQ(saturation(curve, 1e-300), high);
    for (double s : {1e-12, 1e9, 1e30}) {
      const SoilWater<double> w = find_water(curve, s);
      EXPECT_GE(w.saturation, low - 1e-15);
      EXPECT_LE(w.saturation, high);
      EXPECT_TRUE(std::isfinite(w.slope));
    }
    EXPECT_NEAR(saturation(curve, 1e30), low, 2e-7);
  }
}

TEST(Retention, EveryLaneOfAPackGivesWhatADoubleGives) {
  std::mt19937_64 draw(5);
  std::uniform_real_distribution<double> suction(-20e3, 200e3);
  for (const Retention& curve : curves) {
    for (int i = 0; i < 200; ++i) {
      Pack s;
      for (int l = 0; l < lane_width; ++l) s.value[l] = suction(draw);
      const SoilWater<Pack> w = find_water(curve, s);
      for (int l = 0; l < lane_width; ++l) {
        const SoilWater<double> one = find_water(curve, s[l]);
        EXPECT_NEAR(w.saturation[l], one.saturation, 1e-15);
        EXPECT_NEAR(w.slope[l], one.slope, 1e-14 * std::abs(one.slope));
        EXPECT_NEAR(w.effective[l], one.effective, 1e-14);
      }
    }
  }
}

TEST(Retention, FaultsAreSentences) {
  const auto fault = [](const Retention& r) { return find_fault(r).value_or("none"); };
  EXPECT_NE(fault(VanGenuchten{0.6, 0.5, 1e3, 0.3}).find("limits of saturation"), std::string::npos);
  EXPECT_NE(fault(VanGenuchten{0.1, 1.0, 0, 0.3}).find("reference pressure"), std::string::npos);
  EXPECT_NE(fault(VanGenuchten{0.1, 1.0, 1e3, 1}).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(fault(LinearRetention{0.1, 1.0, -1}).find("slope"), std::string::npos);
  EXPECT_NE(fault(ExponentialRetention{0.1, 1.2, 1}).find("limits of saturation"), std::string::npos);
  for (const Retention& curve : curves) EXPECT_EQ(fault(curve), "none");
  using Pairs = std::vector<std::array<double, 2>>;
  for (const Pairs& wrong : {Pairs{{0, 1}}, Pairs{{0, 1}, {0, 0.5}}, Pairs{{0, 1}, {1, 0.5}, {2, 0.7}},
                             Pairs{{0, 0.5}, {1, 0.9}}, Pairs{{-5, 1}, {1, 0.9}}})
    EXPECT_THROW(make_retention_table(wrong, Interpolation::smooth), Error);
}

}  // namespace
}  // namespace talus::material
