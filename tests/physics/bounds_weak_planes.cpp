// SPDX-License-Identifier: MIT
// Limit analysis of soil with weak planes against exact collapse loads: Jaeger's specimen, and a block on its bedding.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds/find_bounds.hpp"
#include "bounds/problem.hpp"
#include "support/bounds_sections.hpp"

namespace talus::bounds {
namespace {

constexpr double pi = std::numbers::pi;

void lay_planes(Problem& problem, double degrees, double cohesion, double friction_degrees) {
  const auto planes = std::make_shared<const WeakPlanes>(
      WeakPlanes{degrees * pi / 180, cohesion, std::tan(friction_degrees * pi / 180)});
  for (auto& corners : problem.strength)
    for (Strength& soil : corners) soil.planes = planes;
}

BoundsOptions until(double gap, int triangles) {
  BoundsOptions options;
  options.gap = gap;
  options.most_triangles = triangles;
  return options;
}

/// Jaeger (1960): without confinement soil carries 2 c cos φ/(1 − sin φ), and planes at β to the horizontal
/// c_j/(sin β cos β − cos²β tan φ_j).
double find_strength(double degrees) {
  const double phi = 30 * pi / 180, beta = degrees * pi / 180, tangent = std::tan(20 * pi / 180);
  const double own = 2 * 10e3 * std::cos(phi) / (1 - std::sin(phi)),
               along = std::sin(beta) * std::cos(beta) - std::cos(beta) * std::cos(beta) * tangent;
  return along > 0 ? std::min(own, 4e3 / along) : own;
}

/// A specimen between smooth plates with free sides.
TEST(WeakPlanes, SpecimenHasJaegersStrength) {
  for (const double degrees : {0.0, 25.0, 40.0, 55.0, 70.0, 85.0, -55.0}) {
    Problem p = make_columns(divide(0, {{1, 2}}), 4, 0, [](double) { return 2.0; });
    std::erase_if(p.sides, [](const Side& s) { return !s.holds_along; });
    for (Side& s : p.sides) s.holds_along = false;
    fill(p, 10e3, 30, 0);
    lay_planes(p, degrees, 4e3, 20);
    press(p, 0, 1, 2, find_strength(std::abs(degrees)));
    const BoundsResult found = find_bounds(p, until(0.002, 200));
    EXPECT_EQ(found.no_lower + found.no_upper, "") << degrees;
    EXPECT_LE(found.lower, 1 + 1e-6) << degrees;
    EXPECT_GE(found.upper, 1 - 1e-6) << degrees;
    EXPECT_LE(found.upper - found.lower, 0.002) << degrees;
  }
}

/// Strong rock above its bedding, which leaves the face at the toe: a block of height H on a plane at β below a face at
/// α has F = (c_j L + W cos β tan φ_j)/(W sin β). The mesh has no lines along the bedding, so that the upper bound is
/// high.
TEST(WeakPlanes, BlockSlidesOnItsBedding) {
  const double beta = 30 * pi / 180, height = 10, face = 60 * pi / 180, weight = 25e3;
  const double area = 0.5 * height * height * (1 / std::tan(beta) - 1 / std::tan(face)),
               length = height / std::sin(beta);
  const double exact =
      (20e3 * length + weight * area * std::cos(beta) * std::tan(25 * pi / 180)) / (weight * area * std::sin(beta));
  for (const bool mirrored : {false, true}) {
    const double toe = 5, crest = toe + height / std::tan(face);
    Problem p = make_columns(divide(0, {{toe, 2}, {crest, 4}, {toe + 17.3, 4}, {30, 3}}), 6, -5,
                             [&](double x) { return std::clamp((x - toe) * std::tan(face), 0.0, height); });
    fill(p, 500e3, 45, weight);
    lay_planes(p, mirrored ? -30 : 30, 20e3, 25);
    if (mirrored) {
      for (Vec<2>& x : p.nodes) x[0] = -x[0];
      for (Triangle& t : p.triangles) std::swap(t[0], t[1]);
    }
    const BoundsResult found = find_bounds(p, until(0.03, 500));
    EXPECT_EQ(found.no_lower + found.no_upper, "");
    EXPECT_LE(found.lower, exact * (1 + 1e-6));
    EXPECT_GE(found.lower, 0.95 * exact);
    EXPECT_GE(found.upper, exact * (1 - 1e-6));
  }
}

/// Planes as strong as the soil change nothing, and weaker ones lower both bounds.
TEST(WeakPlanes, StrongPlanesChangeNothing) {
  Problem p = make_columns(divide(0, {{4, 2}, {14, 4}, {20, 2}}), 3, -3,
                           [](double x) { return std::clamp((x - 4) / 2, 0.0, 5.0); });
  fill(p, 5e3, 20, 18e3);
  const BoundsResult without = find_bounds(p, until(0.05, 400));
  lay_planes(p, 20, 5e3, 20);
  const BoundsResult same = find_bounds(p, until(0.05, 400));
  EXPECT_NEAR(same.lower, without.lower, 0.003 * without.lower);
  EXPECT_NEAR(same.upper, without.upper, 0.003 * without.upper);
  lay_planes(p, 20, 1e3, 12);
  const BoundsResult weaker = find_bounds(p, until(0.05, 400));
  EXPECT_EQ(weaker.no_lower + weaker.no_upper, "");
  EXPECT_LT(weaker.upper, without.lower);
  EXPECT_LE(weaker.upper - weaker.lower, 0.15 * weaker.lower);
}

}  // namespace
}  // namespace talus::bounds
