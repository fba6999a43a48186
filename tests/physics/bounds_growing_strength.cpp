// SPDX-License-Identifier: MIT
// Limit analysis of clay whose strength grows with depth, and of a long slope with seepage, against closed forms. The
// values for clay are those of tools/clay_collapse.py.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bounds/find_bounds.hpp"
#include "support/bounds_sections.hpp"

namespace talus::bounds {
namespace {

void expect_contains(const Problem& problem, double exact, double gap, int triangles) {
  BoundsOptions options;
  options.gap = gap, options.most_triangles = triangles;
  const BoundsResult found = find_bounds(problem, options);
  EXPECT_EQ(found.no_lower + found.no_upper, "");
  EXPECT_LE(found.lower, exact * (1 + 1e-3));
  EXPECT_GE(found.upper, exact * (1 - 1e-3));
  EXPECT_LE(found.upper - found.lower, gap * exact);
}

/// Undrained strength c₀ + ρ z of the soil below y = 0.
void grow(Problem& problem, double cohesion, double gradient) {
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const double y = problem.nodes[static_cast<std::size_t>(problem.triangles[e][i])][1];
      problem.strength[e][i] = {cohesion + gradient * std::max(0.0, -y), 0, {}};
    }
}

/// Half of a strip with B/2 = 2 on s_u = 1 + z, ρB/c₀ = 4 (Davis and Booker 1973). A smooth base has the pressure of
/// the characteristics, which a stress field carries at F = 1 and under which a mechanism moves.
Problem make_smooth_strip() {
  constexpr std::array<double, 9> pressure{5.1416, 6.0067, 6.7174, 7.3481, 7.9283, 8.4729, 8.9909, 9.4879, 9.9679};
  Problem p = make_columns(divide(0, {{2, 8}, {6, 6}}), 5, -2.5, [](double) { return 0.0; });
  fill(p, 1, 0, 0);
  grow(p, 1, 1);
  press(p, 0, 2, 0, 1);
  const auto find_pressure = [&](int node) {
    return pressure.at(static_cast<std::size_t>(std::lround((2 - p.nodes[static_cast<std::size_t>(node)][0]) / 0.25)));
  };
  for (Side& s : p.sides)
    if (s.traction[0][1] != 0) s.traction = {{{0, -find_pressure(s.from)}, {0, -find_pressure(s.to)}}};
  return p;
}

/// The same strip with a rough base, as a rigid block under the pressure q, with ρB/c₀ = `ratio`.
Problem make_rough_strip(double ratio, double q, int parts) {
  constexpr double thick = 0.5;
  Problem p = keep_part(
      make_columns(divide(0, {{2, 2 * parts}, {7, 2 * parts}}), 3 * parts, -2.5, [](double) { return thick; }),
      [](const Vec<2>& x) { return x[0] < 2 || x[1] < 0; });
  fill(p, 1, 0, 0);
  grow(p, 1, ratio / 4);
  for (std::size_t e = 0; e < p.size(); ++e) {
    double y = 0;
    for (const int n : p.triangles[e]) y += p.nodes[static_cast<std::size_t>(n)][1] / 3;
    if (y > 0)
      for (Strength& soil : p.strength[e]) soil.cohesion = 1e5;
  }
  press(p, 0, 2, thick, q);
  return p;
}

TEST(BoundsGrowingStrength, SmoothStripHasThePressureOfTheCharacteristics) {
  expect_contains(make_smooth_strip(), 1, 0.1, 250);
}

/// In `make test-all`.
TEST(BoundsGrowingStrength, StripsOnFineMeshes) {
  expect_contains(make_smooth_strip(), 1, 0.02, 3000);
  for (const auto& [ratio, q] : {std::pair{1.0, 6.6092}, {4.0, 9.1304}, {20.0, 17.4075}})
    expect_contains(make_rough_strip(ratio, q, 2), 1, 0.03, 3000);
}

/// A vertical cut of height 1 in s_u = 1 + 2 z: γH/c₀ is at least 2 (1 + 2), which σ_v = γz and σ_h = 0 carry, and at
/// most 7.9040, of a circle through the toe. That of uniform clay is 1.5 % above the exact value.
void expect_cut(int triangles, double gap) {
  constexpr double circle = 7.9040;
  Problem p = keep_part(make_columns(divide(-1, {{0, 2}, {2, 4}}), 4, -2, [](double) { return 0.0; }),
                        [](const Vec<2>& x) { return x[0] > 0 || x[1] < -1; });
  fill(p, 1, 0, circle);
  grow(p, 1, 2);
  BoundsOptions options;
  options.gap = gap, options.most_triangles = triangles;
  const BoundsResult found = find_bounds(p, options);
  EXPECT_EQ(found.no_lower + found.no_upper, "");
  EXPECT_LE(found.lower, 1);
  EXPECT_GE(found.lower, 1 - gap);
  EXPECT_GE(found.upper, 6 / circle);
  EXPECT_LE(found.upper, 1 + gap);
}

TEST(BoundsGrowingStrength, VerticalCutLiesBetweenAStressFieldAndACircle) {
  expect_cut(250, 0.1);
}

/// In `make test-all`.
TEST(BoundsGrowingStrength, VerticalCutOnFineMeshes) {
  expect_cut(3000, 0.015);
}

/// Water seeps parallel to the ground of a slope of normal depth D: F = (c + γ' D cos β tan φ)/(γ D sin β). The two
/// ends of a piece of it have the stresses of a long slope, whose circle at the depth D touches the criterion, so that
/// the piece has no effect of its ends: its stress field is linear, and a block that slides on the base gains and loses
/// the same work at both ends.
TEST(BoundsGrowingStrength, LongSlopeWithSeepageHasTheFactorOfAPlane) {
  constexpr double depth = 2, weight = 20, water = 9.81, cohesion = 4, slope = 25 * std::numbers::pi / 180,
                   friction = 32 * std::numbers::pi / 180;
  const double exact =
      (cohesion + (weight - water) * depth * std::cos(slope) * std::tan(friction)) / (weight * depth * std::sin(slope));
  // Axes along and across the slope.
  Problem p = make_columns(divide(0, {{8, 12}}), 8, -depth, [](double) { return 0.0; });
  fill(p, cohesion, 32, 0);
  p.body_force.assign(p.size(), {weight * std::sin(slope), -weight * std::cos(slope)});
  for (std::size_t e = 0; e < p.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i)
      p.pore_pressure[e][i] = -water * std::cos(slope) * p.nodes[static_cast<std::size_t>(p.triangles[e][i])][1];
  for (Side& s : p.sides) {
    const auto find_traction = [&](int node) {
      const Vec<2>& x = p.nodes[static_cast<std::size_t>(node)];
      const double shear = -weight * std::sin(slope) * x[1], across = weight * std::cos(slope) * x[1],
                   along = across - 2 * shear * std::tan(friction) / exact, sign = x[0] > 1 ? 1 : -1;
      return Vec<2>{sign * along, sign * shear};
    };
    if (p.nodes[static_cast<std::size_t>(s.from)][0] != p.nodes[static_cast<std::size_t>(s.to)][0]) continue;
    s.holds_normal = s.holds_along = false;
    s.traction = {find_traction(s.from), find_traction(s.to)};
  }
  expect_contains(p, exact, 0.03, 1200);
}

}  // namespace
}  // namespace talus::bounds
