// SPDX-License-Identifier: MIT
// Limit analysis against exact collapse loads: the interval contains the exact factor and narrows with refinement.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <algorithm>
#include <utility>

#include "bounds/conic/solve.hpp"
#include "bounds/find_bounds.hpp"
#include "bounds/problem.hpp"
#include "bounds/refine.hpp"
#include "bounds/uplift.hpp"
#include "bounds/velocities.hpp"
#include "support/bounds_sections.hpp"

namespace talus::bounds {
namespace {

constexpr double pi = std::numbers::pi;

BoundsOptions until(double gap, int triangles) {
  BoundsOptions options;
  options.gap = gap;
  options.most_triangles = triangles;
  return options;
}

void expect_holds(const BoundsResult& found, double exact, double gap) {
  EXPECT_EQ(found.no_lower, "");
  EXPECT_EQ(found.no_upper, "");
  EXPECT_LE(found.lower, exact * (1 + 1e-6));
  EXPECT_GE(found.upper, exact * (1 - 1e-6));
  EXPECT_LE(found.upper - found.lower, gap * exact);
}

/// Prandtl (1920): a strip of pressure on soil without weight carries N_c c, N_c = (N_q − 1) cot φ, N_q = e^{π tan φ}
/// tan²(45° + φ/2), and (2 + π) c without friction. Half of it, from the axis on.
Problem make_strip(double friction_degrees, double width, double depth, int parts) {
  Problem p = make_columns(divide(0, {{1, parts}, {width, 2 * parts}}), 2 * parts, -depth, [](double) { return 0.0; });
  fill(p, 1, friction_degrees, 0);
  const double phi = friction_degrees * pi / 180,
               q = std::exp(pi * std::tan(phi)) * std::pow(std::tan(pi / 4 + phi / 2), 2);
  press(p, 0, 1, 0, phi > 0 ? (q - 1) / std::tan(phi) : 2 + pi);
  return p;
}

TEST(Bounds, PrandtlsStripWithoutFriction) {
  expect_holds(find_bounds(make_strip(0, 4, 2, 2), until(0.05, 600)), 1, 0.05);
}

TEST(Bounds, PrandtlsStripWithFriction) {
  expect_holds(find_bounds(make_strip(30, 9, 5, 2), until(0.06, 1200)), 1, 0.06);
}

/// Reissner (1924): a strip on soil without weight and cohesion, beside a surcharge q, carries N_q q.
TEST(Bounds, ReissnersStripBesideALoad) {
  const double phi = 20 * pi / 180;
  Problem p = make_columns(divide(0, {{1, 3}, {6, 6}}), 5, -3, [](double) { return 0.0; });
  fill(p, 0, 20, 0);
  press(p, 0, 1, 0, std::exp(pi * std::tan(phi)) * std::pow(std::tan(pi / 4 + phi / 2), 2));
  press(p, 1, 6, 0, 1);
  expect_holds(find_bounds(p, until(0.05, 1500)), 1, 0.05);
}

/// A load on heavy soil beside free ground: at its edge a wedge of any size may fail, and the smallest ones as without
/// weight, q = N_c(φ_F) c/F. In `make test-all`.
TEST(Bounds, LoadEdgeOnHeavySoil) {
  constexpr double exact = 1.5, cohesion = 5;
  const double tangent = std::tan(pi / 6) / exact, phi = std::atan(tangent),
               q = std::exp(pi * tangent) * std::pow(std::tan(pi / 4 + phi / 2), 2);
  Problem p = make_columns(divide(0, {{6, 6}, {12, 6}}), 4, -4, [](double) { return 0.0; });
  fill(p, cohesion, 30, 18);
  press(p, 6, 12, 0, (q - 1) / tangent * cohesion / exact);
  expect_holds(find_bounds(p, until(0.03, 2500)), exact, 0.035);
}

/// A trapdoor of width B = 2 under a layer of height H = B without friction. Classical bounds of γ H/c are 2 ln(2H/B),
/// the stresses round a cylinder, and 2H/B, a block (Davis 1968).
TEST(Bounds, Trapdoor) {
  Problem p = make_columns(divide(0, {{1, 3}, {5, 6}}), 5, 0, [](double) { return 2.0; });
  for (Side& s : p.sides) {
    const auto &a = p.nodes[static_cast<std::size_t>(s.from)], &b = p.nodes[static_cast<std::size_t>(s.to)];
    if (a[1] == 0 && b[1] == 0 && a[0] + b[0] < 2) s.holds_normal = s.holds_along = false;
  }
  fill(p, 1, 0, 1);  // γ H/c = 2
  const BoundsResult found = find_bounds(p, until(0.04, 1200));
  EXPECT_LE(2 * found.lower, 2.0);
  EXPECT_GE(2 * found.upper, 2 * std::log(2.0));
  EXPECT_GT(2 * found.lower, 1.9);
  EXPECT_LE(found.upper / found.lower - 1, 0.05);
}

/// A vertical cut in soil without friction: γ H/c between 3.7752 and 3.7776 (Pastor, Thai and Francescato 2000; Lyamin
/// and Sloan 2002).
TEST(Bounds, VerticalCut) {
  const Problem p = [] {
    // Height 1, of which the left part is dug away: the floor is level with the toe.
    Problem cut = keep_part(make_columns(divide(0, {{1, 4}, {2.5, 6}}), 8, -1, [](double) { return 1.0; }),
                            [](const Vec<2>& x) { return x[0] > 1 || x[1] < 0; });
    fill(cut, 1, 0, 3.7764);
    return cut;
  }();
  const BoundsResult found = find_bounds(p, until(0.04, 900));
  EXPECT_LE(3.7764 * found.lower, 3.7776);
  EXPECT_GE(3.7764 * found.upper, 3.7752);
  EXPECT_LE(found.upper / found.lower - 1, 0.05);
}

Problem make_slope(double cohesion, double friction_degrees, double unit_weight, bool mirrored = false,
                   double shift = 0) {
  Problem p = make_columns(divide(0, {{12, 3}, {32, 5}, {44, 3}}), 3, 0, [](double x) {
    return x <= 12 ? 15.0 : x >= 32 ? 5.0 : 15 - (x - 12) / 2;
  });
  fill(p, cohesion, friction_degrees, unit_weight);
  for (Vec<2>& x : p.nodes) x = {(mirrored ? -x[0] : x[0]) + shift, x[1] + shift};
  if (mirrored)
    for (Triangle& t : p.triangles) std::swap(t[0], t[1]);
  return p;
}

/// Without cohesion the face slides first: F = tan φ / tan β. A field of stress proves it.
TEST(Bounds, SlopeWithoutCohesion) {
  const double exact = 2 * std::tan(pi / 6);
  const BoundsResult found = find_bounds(make_slope(0, 30, 15598), until(0.02, 400));
  EXPECT_LE(found.lower, exact * (1 + 2e-5));  // with the cohesion of a millionth
  EXPECT_GE(found.lower, 0.99 * exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LE(found.upper, 1.08 * exact);
}

/// A face steeper than 45° needs φ_F = β there, with which no velocity can dilate in the corners between the fixed base
/// and the fixed ends: soil is at rest in them, and the face slides at F = tan φ / tan β, as between smooth ends.
TEST(Bounds, SteepSlopeBetweenFixedEnds) {
  constexpr double steep = 1.25;
  Problem p = make_columns(divide(0, {{4, 2}, {8, 4}, {14, 3}}), 4, 0, [](double x) {
    return x <= 4 ? 10.0 : x >= 8 ? 5.0 : 10 - steep * (x - 4);
  });
  fill(p, 0, 30, 18000);
  const double exact = std::tan(pi / 6) / steep;
  const BoundsResult smooth = find_bounds(p, until(0.03, 1));
  for (Side& s : p.sides) s.holds_along = true;
  const BoundsResult found = find_bounds(p, until(0.03, 1));
  EXPECT_LE(found.lower, exact * (1 + 1e-4));  // with the cohesion of a millionth
  EXPECT_GE(found.lower, 0.97 * exact);
  EXPECT_GE(found.upper, exact);
  EXPECT_LE(found.upper, 1.01 * smooth.upper);
  // Wider than 2 φ_F they do not hold the soil.
  const Units units = find_units(p);
  EXPECT_FALSE(hold_narrow_corners(p, 1, units));
  EXPECT_TRUE(hold_narrow_corners(p, exact, units));
}

/// Soil that bears no tension carries less.
TEST(Bounds, SoilWithoutTensionCarriesLess) {
  Problem p = make_slope(30000, 0, 18000);
  const BoundsResult with = find_bounds(p, until(0.03, 700));
  for (auto& corners : p.strength)
    for (Strength& soil : corners) soil.tension = 0;
  const BoundsResult without = find_bounds(p, until(0.03, 900));
  EXPECT_LE(with.lower, with.upper);
  EXPECT_LE(without.lower, without.upper);
  EXPECT_LT(without.upper, with.lower);
}

TEST(Bounds, GivesTheReasonForAMissingBound) {
  Problem p = make_slope(0.001, 1, 18000);
  BoundsResult found = find_bounds(p, until(0.05, 100));
  EXPECT_EQ(found.lower, 0);
  EXPECT_NE(found.no_lower, "");
  p = make_slope(1e9, 0, 18000);
  found = find_bounds(p, until(0.05, 100));
  // The fields of the largest factor tried prove a larger one: both bounds stay, and the message names the end of the
  // range.
  EXPECT_EQ(found.stopped, "the slope is stable at every factor up to 20");
  EXPECT_GT(found.lower, 20);
  EXPECT_GT(found.upper, found.lower);
  p = make_slope(1000, 20, 18000);
  p.sides.clear();
  found = find_bounds(p, until(0.05, 100));
  EXPECT_EQ(found.no_lower, "no stress field is in equilibrium with the loads");
}

/// Pore pressures of r_u in soil without cohesion: F = (cos²β − r_u) tan φ / (sin β cos β), Skempton and DeLory (1957).
TEST(Bounds, SlopeWithPorePressures) {
  constexpr double ratio = 0.2, weight = 20000;
  const auto find_ground = [](double x) { return x <= 12 ? 15.0 : x >= 32 ? 5.0 : 15 - (x - 12) / 2; };
  Problem p = make_slope(0, 30, weight);
  for (std::size_t e = 0; e < p.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<2>& x = p.nodes[static_cast<std::size_t>(p.triangles[e][i])];
      p.pore_pressure[e][i] = ratio * weight * (find_ground(x[0]) - x[1]);
    }
  const double cosine = 2 / std::sqrt(5.0), sine = 1 / std::sqrt(5.0);
  const double exact = (cosine * cosine - ratio) * std::tan(pi / 6) / (sine * cosine);
  const BoundsResult found = find_bounds(p, until(0.02, 500));
  EXPECT_LE(found.lower, exact * (1 + 1e-4));
  EXPECT_GE(found.lower, 0.98 * exact);
  EXPECT_GE(found.upper, exact * (1 - 1e-6));
}

/// The total stress across a free surface is zero, so its effective stress is the pore pressure u as tension, which the
/// criterion admits up to c / tan φ = 5 kPa / tan 28° = 9.404 kPa, whatever F divides both by.
TEST(Bounds, NamesThePorePressureThatNoStressFieldCarries) {
  const double apex = 5000 / std::tan(28 * pi / 180);
  Problem p = make_slope(5000, 28, 18000);
  const auto wet = [&](double pressure) {
    for (auto& corners : p.pore_pressure) corners.fill(pressure);
    return search_uplift(p);
  };
  EXPECT_FALSE(wet(0.99 * apex));
  const auto found = wet(1.02 * apex);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->pull, 1.02 * apex, 1e-6);
  EXPECT_NEAR(found->limit, apex, 1e-6);
  const BoundsResult bounds = find_bounds(p, until(0.05, 100));
  EXPECT_EQ(bounds.lower, 0);
  EXPECT_NE(bounds.no_lower.find("c / tan φ = 9.4 kPa"), std::string::npos) << bounds.no_lower;
  // A pond of 2 kPa on every free side leaves 1.02 of the apex less 2 kPa.
  for (const Edge& edge : list_edges(p.triangles)) {
    const auto is_edge = [&](const Side& s) { return make_key(s.from, s.to) == make_key(edge.from, edge.to); };
    if (edge.other >= 0 || std::any_of(p.sides.begin(), p.sides.end(), is_edge)) continue;
    const Vec<2>&a = p.nodes[static_cast<std::size_t>(edge.from)], &b = p.nodes[static_cast<std::size_t>(edge.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vec<2> load{-2000 * (b[1] - a[1]) / length, 2000 * (b[0] - a[0]) / length};
    p.sides.push_back({edge.from, edge.to, false, false, {load, load}});
  }
  EXPECT_FALSE(search_uplift(p));
}

/// A quarter of a thick cylinder without friction yields at the pressure 2 c ln(b/a). With chords in place of arcs it
/// is nearly one.
TEST(Bounds, ThickCylinder) {
  constexpr int rings = 4, sectors = 12;
  constexpr double inner = 1, outer = 2;
  Problem p = make_columns(divide(0, {{1, sectors}}), rings, 0, [](double) { return 1.0; });
  fill(p, 1, 0, 0);
  for (Vec<2>& x : p.nodes) {
    const double r = inner + (outer - inner) * x[1], angle = pi / 2 * (1 - x[0]);
    x = {r * std::cos(angle), r * std::sin(angle)};
  }
  // The two straight ends slide; pressure acts on the inner chords.
  std::vector<Side> sides;
  const double pressure = 2 * std::log(outer / inner);
  for (const Edge& edge : list_edges(p.triangles)) {
    if (edge.other >= 0) continue;
    const Vec<2>&a = p.nodes[static_cast<std::size_t>(edge.from)], &b = p.nodes[static_cast<std::size_t>(edge.to)];
    if (std::abs(a[0]) + std::abs(b[0]) < 1e-9 || std::abs(a[1]) + std::abs(b[1]) < 1e-9) {
      sides.push_back({edge.from, edge.to, true, false, {}});
    } else if (std::hypot(a[0], a[1]) < inner + 1e-9 && std::hypot(b[0], b[1]) < inner + 1e-9) {
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const Vec<2> t{-pressure * (b[1] - a[1]) / length, pressure * (b[0] - a[0]) / length};
      sides.push_back({edge.from, edge.to, false, false, {t, t}});
    }
  }
  p.sides = sides;
  const BoundsResult found = find_bounds(p, until(0.02, 800));
  constexpr double chords = 0.01;
  EXPECT_EQ(found.no_lower + found.no_upper, "");
  EXPECT_LE(found.lower, 1 + chords);
  EXPECT_GE(found.upper, 1 - chords);
  EXPECT_LE(found.upper - found.lower, 0.03);
}

/// Edges along x with the tension of a bar, linear between levels (from the head down).
std::vector<BarEdge> make_vertical_bar(const Problem& p, double x, const std::vector<std::array<double, 2>>& tension,
                                       bool is_reduced) {
  const auto find = [&](double y) {
    for (std::size_t i = 1; i < tension.size(); ++i)
      if (y <= tension[i - 1][0] + 1e-9 && y >= tension[i][0] - 1e-9)
        return tension[i - 1][1] +
               (tension[i][1] - tension[i - 1][1]) * (tension[i - 1][0] - y) / (tension[i - 1][0] - tension[i][0]);
    return -1.0;
  };
  std::vector<BarEdge> bars;
  for (const Edge& edge : list_edges(p.triangles)) {
    const auto &a = p.nodes[static_cast<std::size_t>(edge.from)], &b = p.nodes[static_cast<std::size_t>(edge.to)];
    if (std::abs(a[0] - x) + std::abs(b[0] - x) > 1e-9 || find(a[1]) < 0 || find(b[1]) < 0) continue;
    const bool is_down = a[1] > b[1];
    bars.push_back({is_down ? edge.from : edge.to,
                    is_down ? edge.to : edge.from,
                    {find(std::max(a[1], b[1])), find(std::min(a[1], b[1]))},
                    is_reduced});
  }
  return bars;
}

/// The weight γ of soil of tensile strength T acts upwards and pulls it off a strong base of width B = 2, across which
/// a bar bears N. With T B/F + N = γ H B the factor is T B/(γ H B − N); where F divides N too, (T B + N)/(γ H B).
TEST(Bounds, ABarHoldsSoilThatHangs) {
  constexpr double tension = 1, weight = 3, force = 2, width = 2;
  for (const bool is_reduced : {false, true}) {
    Problem p = make_columns(divide(0, {{width, 4}}), 8, -1, [](double) { return 1.0; });
    fill(p, 100, 0, -weight);
    for (std::size_t e = 0; e < p.size(); ++e) {
      double y = 0;
      for (const int n : p.triangles[e]) y += p.nodes[static_cast<std::size_t>(n)][1] / 3;
      for (Strength& s : p.strength[e]) s.tension = y > 0 ? tension : 100 * tension;
    }
    p.bars = make_vertical_bar(p, 1, {{1, 0}, {0, force}, {-0.75, 0}}, is_reduced);
    EXPECT_EQ(p.bars.size(), 7u);
    const double exact =
        is_reduced ? (tension * width + force) / (weight * width) : tension * width / (weight * width - force);
    expect_holds(find_bounds(p, until(0.05, 500)), exact, 0.2);
    // The same force up to a head on the free side, whose plate is as wide as the soil.
    p.bars = make_vertical_bar(p, 1, {{1, force}, {0, force}, {-0.75, 0}}, is_reduced);
    BarHead head{p.bars.front().from, {0, -1}, force, is_reduced, {}};
    for (const BarEdge& bar : p.bars)
      if (p.nodes[static_cast<std::size_t>(bar.from)][1] > 1 - 1e-9) head.node = bar.from;
    for (const Edge& edge : list_edges(p.triangles))
      if (p.nodes[static_cast<std::size_t>(edge.from)][1] + p.nodes[static_cast<std::size_t>(edge.to)][1] > 2 - 1e-9)
        head.sides.push_back({edge.from, edge.to});
    ASSERT_EQ(head.sides.size(), 4u);
    p.heads = {head};
    expect_holds(find_bounds(p, until(0.05, 500)), exact, 0.2);
    p.bars.clear(), p.heads.clear();
    expect_holds(find_bounds(p, until(0.05, 500)), tension / weight, 0.08);
  }
}

/// The derivative of the lack against a difference.
TEST(Bounds, RateOfTheLack) {
  Problem p = make_slope(5000, 20, 18000);
  for (std::size_t e = 0; e < p.size(); e += 2)
    for (Strength& soil : p.strength[e]) soil.tension = 3000;
  p.bars = make_vertical_bar(p, 8, {{15, 0}, {10, 8000}, {0, 0}}, true);
  ASSERT_FALSE(p.bars.empty());
  const Units units = find_units(p);
  ConicOptions tight;
  tight.tolerance = 1e-8;
  for (const Bound bound : {Bound::lower, Bound::upper}) {
    const auto find = [&](double factor) { return solve(make_program(p, bound, factor, units), tight); };
    constexpr double factor = 1.1, step = 1e-3;
    const double difference = (find(factor + step).primal - find(factor - step).primal) / (2 * step);
    EXPECT_NEAR(find_lack_rate(p, make_program(p, bound, factor, units), bound, factor, units, find(factor)),
                difference, 1e-3 * std::abs(difference));
  }
}

/// Clay over sand: the clay keeps its volume, and is lifted as a whole by sand that opens.
TEST(Bounds, ClayAndSand) {
  Problem p = make_slope(5000, 20, 18000);
  constexpr std::size_t lowest_row = 4 * 11;  // of crossed triangles
  for (std::size_t e = lowest_row; e < p.size(); ++e)
    for (Strength& soil : p.strength[e]) soil = {40000, 0, {}};
  const BoundsResult found = find_bounds(p, until(0.05, 600));
  EXPECT_EQ(found.no_lower + found.no_upper, "");
  EXPECT_LE(found.lower, found.upper);
  EXPECT_LE(found.upper / found.lower, 1.1);
}

/// The dry slope of the source: Spencer's factor is 1.439. Each mesh can only make the interval narrower.
TEST(Bounds, DrySlopeTightens) {
  std::vector<BoundsLevel> levels;
  const BoundsResult found = find_bounds(make_slope(2000, 30, 15597.9), until(0.03, 600),
                                         [&](const BoundsResult& r) { levels.push_back(r.levels.back()); });
  expect_holds(found, 1.435, 0.04);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_GE(levels[i].lower, levels[i - 1].lower);
    EXPECT_LE(levels[i].upper, levels[i - 1].upper);
  }
  EXPECT_TRUE(check(found.stress_problem, found.stress).holds);
  EXPECT_DOUBLE_EQ(check(found.stress_problem, found.stress).factor, found.lower);
  EXPECT_DOUBLE_EQ(check(found.velocity_problem, found.velocity).factor, found.upper);
}

TEST(Bounds, MirroredMovedAndInOtherUnitsItIsTheSameSlope) {
  const BoundsResult here = find_bounds(make_slope(30000, 0, 18000), until(0.5, 100));
  const BoundsResult there = find_bounds(make_slope(30000, 0, 18000, true, 1000), until(0.5, 100));
  EXPECT_NEAR(there.lower, here.lower, 1e-4);
  EXPECT_NEAR(there.upper, here.upper, 1e-4);
  // In feet and pounds, 1 ft = 0.3048 m and 1 lbf = 4.448 N.
  constexpr double foot = 0.3048, pound = 4.448;
  Problem scaled = make_slope(30000 * foot * foot / pound, 0, 18000 * foot * foot * foot / pound);
  for (Vec<2>& x : scaled.nodes) x = {x[0] / foot, x[1] / foot};
  const BoundsResult other = find_bounds(scaled, until(0.5, 100));
  EXPECT_NEAR(other.lower, here.lower, 1e-4);
  EXPECT_NEAR(other.upper, here.upper, 1e-4);
}

/// A field that somebody changed proves less, or nothing.
TEST(Bounds, ChecksFindWhatWasChanged) {
  const BoundsResult found = find_bounds(make_slope(2000, 30, 15597.9), until(0.5, 100));
  StressField stress = found.stress;
  ASSERT_TRUE(check(found.stress_problem, stress).holds);
  stress.stress[40][1][2] += 1;
  EXPECT_FALSE(check(found.stress_problem, stress).holds);
  stress = found.stress;
  stress.stress[40][1][2] = std::nan("");
  EXPECT_FALSE(check(found.stress_problem, stress).holds);
  EXPECT_EQ(check(found.stress_problem, stress).factor, 0);
  VelocityField velocity = found.velocity;
  velocity.velocity[velocity.velocity.size() / 2][0] = std::nan("");
  EXPECT_FALSE(check(found.velocity_problem, velocity).holds);
  velocity = found.velocity;
  velocity.mesh.triangles[7][3] = velocity.mesh.triangles[0][0];  // an edge that its two triangles move differently
  EXPECT_FALSE(check(found.velocity_problem, velocity).holds);
  velocity = found.velocity;
  const Problem& moving = found.velocity_problem;
  ASSERT_TRUE(check(moving, velocity).holds);
  for (const Side& s : moving.sides)
    if (s.holds_normal)
      velocity.velocity[static_cast<std::size_t>(s.from)][1] = velocity.velocity[static_cast<std::size_t>(s.from)][0] =
          1;
  EXPECT_FALSE(check(moving, velocity).holds);
}

/// Halving keeps area and border, and every edge has the same neighbours from both sides.
/// Pressures that differ by rounding at a node are no jump, around which the mesh would be made finer.
TEST(Bounds, CornersAreWhereLoadsJump) {
  Problem p = make_columns(divide(0, {{10, 10}}), 2, 0, [](double) { return 2.0; });
  fill(p, 1, 20, 1);
  press(p, 0, 10, 2, 1);
  const std::vector<int> level = find_corners(p);
  for (Side& s : p.sides)
    if (s.traction[0][1] != 0) s.traction[1][1] *= 1 + 1e-14;
  EXPECT_EQ(find_corners(p), level);
  Side& jumps = p.sides.back();
  for (Vec<2>& t : jumps.traction) t[1] *= 2;
  EXPECT_GT(find_corners(p).size(), level.size());
}

/// One triangle fills the corner between a fixed base and a fixed end. It cannot strain at that corner, where every
/// flow rule holds with no margin, and its velocities are corrected as those of any other.
TEST(Bounds, SoilOpensBesideATriangleBetweenFixedSides) {
  Problem p;
  p.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  p.triangles = {{0, 1, 3}, {1, 2, 3}};
  p.sides = {{0, 1, true, true, {}}, {3, 0, true, true, {}}};
  fill(p, 1, 30, 1);
  const Velocities mesh = number_velocities(p, find_units(p));
  const std::vector<bool> opens = find_opening_corners(p, mesh);
  EXPECT_FALSE(opens[0]);
  EXPECT_EQ(std::count(opens.begin(), opens.end(), true), 5);
  OpeningSearch search;
  EXPECT_NE(search.find(p, mesh, 1, 1), nullptr);
}

TEST(Bounds, RefinementKeepsTheSection) {
  Problem p = make_slope(1, 0, 1);
  auto find_area = [](const Problem& q) {
    double area = 0;
    for (std::size_t e = 0; e < q.size(); ++e) area += find_shape(q, e).area;
    return area;
  };
  const double area = find_area(p);
  for (int round = 0; round < 4; ++round) {
    std::vector<bool> marked(p.size(), false);
    for (std::size_t e = 0; e < p.size(); e += 7) marked[e] = true;
    const Problem before = std::exchange(p, refine(p, marked));
    EXPECT_NEAR(find_area(p), area, 1e-9 * area);
    const auto find_marked_area = [](const Problem& q, const std::vector<bool>& of) {
      double sum = 0;
      for (std::size_t e = 0; e < q.size(); ++e) sum += of[e] ? find_shape(q, e).area : 0;
      return sum;
    };
    EXPECT_NEAR(find_marked_area(p, mark_inside(before, marked, p)), find_marked_area(before, marked), 1e-9 * area);
    for (std::size_t e = 0; e < p.size(); ++e) EXPECT_GT(find_shape(p, e).area, 0);
    // Euler's number of a disk: nodes − edges + triangles = 1.
    std::vector<bool> used(p.nodes.size(), false);
    for (const Triangle& t : p.triangles)
      for (const int n : t) used[static_cast<std::size_t>(n)] = true;
    const auto nodes = std::count(used.begin(), used.end(), true);
    EXPECT_EQ(nodes - static_cast<long>(list_edges(p.triangles).size()) + static_cast<long>(p.size()), 1);
  }
}

}  // namespace
}  // namespace talus::bounds
