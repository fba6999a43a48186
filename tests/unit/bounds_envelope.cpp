// SPDX-License-Identifier: MIT
// Polygons inside and outside curved strength envelopes, for both bounds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bounds/envelope.hpp"
#include "material/curved_envelopes.hpp"
#include "material/hoek_brown.hpp"

namespace talus::bounds {
namespace {

double find_least(const Strength& polygon, double normal) {
  double least = 1e300;
  polygon.visit_lines([&](double more_cohesion, double tan_friction) {
    least = std::min(least, polygon.cohesion + more_cohesion + normal * tan_friction);
  });
  return least;
}

void expect_encloses(const auto& envelope, double usual) {
  constexpr double tolerance = 0.01;
  const auto find_tangent = [&](double normal) { return envelope.find_tangent(normal); };
  const auto [inner, outer] = enclose_envelope(find_tangent, {envelope.straight_below(), usual, tolerance});
  ASSERT_TRUE(inner.further && outer.further);
  EXPECT_LE(inner.further->size(), 20u);
  for (const Strength* polygon : {&inner, &outer}) {
    double last = polygon->tan_friction;
    for (const FurtherLine& line : *polygon->further) EXPECT_LT(line.tan_friction, last), last = line.tan_friction;
  }
  const double lowest = envelope.straight_below();
  for (int i = 0; i <= 3000; ++i) {
    const double normal = lowest + (40 * usual - lowest) * std::pow(i / 3000.0, 4);
    const StrengthTangent t = envelope.find_tangent(normal);
    const double strength = t.cohesion + normal * t.tan_friction, rounding = 1e-9 * usual;
    EXPECT_LE(find_least(inner, normal), strength + rounding) << normal;
    EXPECT_GE(find_least(outer, normal), strength - rounding) << normal;
    if (normal < 1.5 * usual && normal > lowest) {
      EXPECT_LE(find_least(outer, normal) - find_least(inner, normal),
                std::max(tolerance * find_least(outer, normal), tolerance / 2 * find_least(outer, usual)) + rounding)
          << normal;
    }
  }
}

TEST(BoundsEnvelope, PolygonsEncloseTheLaws) {
  expect_encloses(material::make_rock_mass({30e6, 5, 2, 0}), 400e3);
  expect_encloses(material::make_rock_mass({30e6, 45, 10, 0.9}), 2e6);
  expect_encloses(material::PowerEnvelope{2, 0.7, 0, 0}, 200e3);
  expect_encloses(material::PowerEnvelope{1.2, 0.5, 3000, 1000}, 200e3);
  expect_encloses(material::StrengthPairs{{0, 40e3, 120e3, 400e3}, {4e3, 40e3, 90e3, 200e3}}, 200e3);
}

TEST(BoundsEnvelope, AStraightOneIsOneLineOutside) {
  const material::StrengthPairs pairs{{0, 100e3}, {5e3, 55e3}};
  const auto [inner, outer] =
      enclose_envelope([&](double normal) { return pairs.find_tangent(normal); }, {0, 200e3, 0.005});
  EXPECT_FALSE(outer.further);
  EXPECT_NEAR(outer.cohesion, 5e3, 1e-6);
  EXPECT_NEAR(outer.tan_friction, 0.5, 1e-12);
  ASSERT_TRUE(inner.further);
  EXPECT_EQ(inner.further->size(), 1u) << "the horizontal line above the last chord";
}

TEST(BoundsEnvelope, TheFactorOfAStressIsThatOfTheWorstLine) {
  Strength soil{5e3, 0.8, {}, true, std::make_shared<const std::vector<FurtherLine>>(1, FurtherLine{20e3, 0.3})};
  const Stress steep{-10e3, -16e3, 2e3}, flat{-150e3, -300e3, 0};
  EXPECT_EQ(find_factor(soil, steep), find_factor({5e3, 0.8, {}}, steep));
  EXPECT_EQ(find_factor(soil, flat), find_factor({25e3, 0.3, {}}, flat));
}

TEST(BoundsEnvelope, ProgramsHaveTheLinesNextToTheStresses) {
  std::vector<FurtherLine> further;
  for (int i = 1; i < 10; ++i) further.push_back({i * i * 1e3, 1 - 0.1 * i});
  const Strength soil{1e3, 1, {}, true, std::make_shared<const std::vector<FurtherLine>>(further)};
  Problem problem;
  problem.triangles = {{0, 1, 2}};
  problem.strength = {{soil, soil, soil}};
  // At F = 1 lines i and i + 1 meet at σ'_n = (2i + 1) 10 kPa; the mean stresses are −45 kPa and, at one corner, −65.
  const std::vector<double> even{-45, 0, 0, -45, 0, 0, -45, 0, 0}, other{-45, 0, 0, -45, 0, 0, -65, 0, 0};
  choose_lines(problem, {1, 1e3}, {{{1, &even}, {1, &other}}});
  const auto nearest = [&](double mean) {
    std::size_t number = 0, least = 0;
    double distance = 1e300;
    soil.visit_lines([&](double more, double tangent) {
      const double own = (soil.cohesion + more - mean * tangent) / std::hypot(1.0, tangent);
      if (own < distance) distance = own, least = number;
      ++number;
    });
    return least;
  };
  ASSERT_GT(nearest(-65e3), nearest(-45e3));
  std::size_t count = 0;
  problem.strength[0][1].visit_programmed_lines([&](double, double) { ++count; });
  EXPECT_EQ(count, nearest(-65e3) - nearest(-45e3) + 3) << "one more on either side";
  EXPECT_EQ(problem.strength[0][1].count_rows(), 3 * count);
  EXPECT_EQ(problem.strength[0][1].programmed.first, nearest(-45e3) - 1);
  // The proof is held to all lines.
  const Stress deep{-900e3, -900e3, 30e3};
  EXPECT_EQ(find_factor(problem.strength[0][1], deep), find_factor(soil, deep));
}

}  // namespace
}  // namespace talus::bounds
