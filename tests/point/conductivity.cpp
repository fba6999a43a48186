// SPDX-License-Identifier: MIT
// Laws of relative conductivity against closed-form values, finite differences and limits, and packs against doubles.

#include "material/water/conductivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"

namespace talus::material {
namespace {

const VanGenuchten loess{0.0, 1.0, 15630, 0.288};
const VanGenuchten sand{0.15, 1.0, 6130, 0.27};
const std::vector<std::array<double, 2>> measured = {{0, 1}, {1e3, 0.5}, {10e3, 1e-3}, {100e3, 1e-6}};

struct Soil {
  Retention retention;
  Conductivity law;
};
const std::vector<Soil> soils = {
    {loess, ConstantConductivity{}},
    {loess, Mualem{0.288}},
    {sand, Mualem{0.27}},
    {sand, Mualem{0.27, SaturationMeasure::effective}},
    {VanGenuchten{0.6, 1.0, 8500, 0.43}, Hillel{2.3}},
    {sand, Hillel{3, SaturationMeasure::effective}},
    {sand, Mualem::with_air_entry(0.27, SaturationMeasure::effective, sand, 200)},
    {ExponentialRetention{0.1, 1, 1e-3}, ExponentialConductivity{1e-3}},
    {sand, make_conductivity_table(measured, Interpolation::linear)},
    {sand, make_conductivity_table(measured, Interpolation::smooth)},
    {sand, make_conductivity_table(measured, Interpolation::linear, false)},
};

double relative(const Soil& soil, double s) {
  return find_relative_conductivity(soil.law, find_water(soil.retention, s)).value;
}

TEST(Conductivity, IntrinsicPermeabilityOfTheUnsaturatedSlope) {
  EXPECT_NEAR(find_conductivity(6e-11, 1000, 9.81, 1e-3), 5.886e-4, 1e-10);  // section 3.4.2
}

TEST(Conductivity, LawsGiveTheirClosedValues) {
  const double s = 30e3, x = 0.15 + 0.85 * std::pow(1 + std::pow(s / 6130, 1 / 0.73), -0.27), e = (x - 0.15) / 0.85;
  const auto mualem = [](double w, double l) {
    return std::sqrt(w) * std::pow(1 - std::pow(1 - std::pow(w, 1 / l), l), 2);
  };
  EXPECT_NEAR(relative(soils[2], s) / mualem(x, 0.27), 1, 1e-12);
  EXPECT_NEAR(relative(soils[3], s) / mualem(e, 0.27), 1, 1e-12);
  const double entry = relative(soils[3], 200);
  EXPECT_NEAR(relative(soils[6], s) / (relative(soils[3], s) / entry), 1, 1e-12);
  EXPECT_EQ(relative(soils[6], 199), 1);
  // van Genuchten's (1980) own closed form of the second in suction
  const double n = 1 / 0.73, u = s / 6130;
  const double vg = std::pow(1 - std::pow(u, n - 1) * std::pow(1 + std::pow(u, n), -0.27), 2) /
                    std::pow(1 + std::pow(u, n), 0.27 / 2);
  EXPECT_NEAR(relative(soils[3], s) / vg, 1, 1e-12);
  EXPECT_NEAR(relative(soils[4], 8500) / std::pow(0.6 + 0.4 * std::pow(2, -0.43), 2.3), 1, 1e-13);
  EXPECT_NEAR(relative(soils[7], 2e3) / std::exp(-2), 1, 1e-13);
  EXPECT_NEAR(relative(soils[8], 5.5e3), std::sqrt(0.5 * 1e-3), 1e-14);  // the middle of the logarithms
  EXPECT_NEAR(relative(soils[10], 5.5e3), (0.5 + 1e-3) / 2, 1e-14);
}

TEST(Conductivity, IsSaturatedBelowZeroSuctionAndNeverRises) {
  for (std::size_t i = 0; i < soils.size(); ++i) {
    for (double s : {-1e6, -1.0, 0.0}) {
      const auto k = find_relative_conductivity(soils[i].law, find_water(soils[i].retention, s));
      EXPECT_EQ(k.value, 1) << i;
      EXPECT_EQ(k.slope, 0) << i;
    }
    double last = 1;
    for (double s = 1e-12; s < 1e7; s *= 1.3) {
      const double k = relative(soils[i], s);
      EXPECT_LE(k, last + 1e-13) << i << " at " << s;
      EXPECT_GE(k, 0) << i;
      last = k;
    }
  }
}

TEST(Conductivity, SlopesAreTheDifferences) {
  for (std::size_t i = 0; i < soils.size(); ++i) {
    for (double s = 3.7; s < 1e6; s *= 1.07) {
      const auto k = find_relative_conductivity(soils[i].law, find_water(soils[i].retention, s));
      const double h = 2e-5 * s, d = (relative(soils[i], s + h) - relative(soils[i], s - h)) / (2 * h);
      EXPECT_NEAR(k.slope, d, 1e-6 * std::abs(d) + 1e-10 / s) << i << " at " << s;
    }
  }
}

TEST(Conductivity, EveryLaneOfAPackGivesWhatADoubleGives) {
  std::mt19937_64 draw(7);
  std::uniform_real_distribution<double> suction(-20e3, 200e3);
  for (const Soil& soil : soils) {
    for (int i = 0; i < 200; ++i) {
      Pack s;
      for (int l = 0; l < lane_width; ++l) s.value[l] = suction(draw);
      const CurvePoint<Pack> k = find_relative_conductivity(soil.law, find_water(soil.retention, s));
      for (int l = 0; l < lane_width; ++l) {
        const auto one = find_relative_conductivity(soil.law, find_water(soil.retention, s[l]));
        EXPECT_NEAR(k.value[l], one.value, 1e-12 * one.value);
        EXPECT_NEAR(k.slope[l], one.slope, 1e-11 * std::abs(one.slope));
      }
    }
  }
}

TEST(Conductivity, FaultsAreSentences) {
  EXPECT_NE(find_fault(Conductivity(Mualem{1.2})).value_or("").find("between 0 and 1"), std::string::npos);
  EXPECT_NE(find_fault(Conductivity(Hillel{-1})).value_or("").find("0 or above"), std::string::npos);
  EXPECT_NE(find_fault(Conductivity(ExponentialConductivity{-1})).value_or("").find("0 or above"), std::string::npos);
  for (const Soil& soil : soils) EXPECT_FALSE(find_fault(soil.law));
  EXPECT_THROW(make_conductivity_table({{0, 1}, {1, 0}}, Interpolation::linear), Error);
  EXPECT_THROW(make_conductivity_table({{0, 0.5}, {1, 0.7}}, Interpolation::linear), Error);
}

}  // namespace
}  // namespace talus::material
