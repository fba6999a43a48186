// SPDX-License-Identifier: MIT
// Walls in limit analysis against closed forms: hinges, struts, interfaces, and loads on the wall itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds/find_bounds.hpp"
#include "bounds/refine.hpp"
#include "bounds/wall_check.hpp"
#include "support/bounds_sections.hpp"

namespace talus::bounds {
namespace {

constexpr double height = 2, load = 50e3, weight = 20e3, cohesion = 20e3;

/// Clay of 2 m with a load behind a wall at x = 0, on ground that does not yield, in front of which there is air.
Problem make_retained(double spacing) {
  const int parts = static_cast<int>(std::lround(1 / spacing));
  Problem p = make_columns(divide(-2, {{0, 2 * parts}, {4, 4 * parts}}), 4 * parts, -2, [](double) { return height; });
  const auto is_air = [&](int node) {
    const Vec<2>& x = p.nodes[static_cast<std::size_t>(node)];
    return x[0] < -1e-9 && x[1] > 1e-9;
  };
  std::erase_if(p.triangles, [&](const Triangle& t) { return std::any_of(t.begin(), t.end(), is_air); });
  std::erase_if(p.sides, [&](const Side& s) { return is_air(s.from) || is_air(s.to); });
  fill(p, cohesion, 0, weight);
  for (std::size_t e = 0; e < p.size(); ++e) {
    double level = 0;
    for (const int node : p.triangles[e]) level += p.nodes[static_cast<std::size_t>(node)][1] / 3;
    if (level < 0)
      for (Strength& soil : p.strength[e]) soil.cohesion = 1e9;
  }
  press(p, 0, 4, height, load);
  return p;
}

/// Adds a wall along x = 0 from the ground down to a level, smooth above y = 0 and rough below.
Wall& add_wall(Problem& p, double toe) {
  Wall& wall = p.walls.emplace_back();
  for (std::size_t n = 0; n < p.nodes.size(); ++n)
    if (std::abs(p.nodes[n][0]) < 1e-9 && p.nodes[n][1] > toe - 1e-9) wall.nodes.push_back(static_cast<int>(n));
  const auto get_level = [&](int node) { return p.nodes[static_cast<std::size_t>(node)][1]; };
  std::sort(wall.nodes.begin(), wall.nodes.end(), [&](int a, int b) { return get_level(a) > get_level(b); });
  for (std::size_t i = 0; i + 1 < wall.nodes.size(); ++i) {
    const InterfaceStrength strength{get_level(wall.nodes[i + 1]) > -1e-9 ? 0 : 1e9, 0};
    wall.interface.push_back({strength, strength});
  }
  return wall;
}

int find_node(const Problem& p, double x, double y) {
  for (std::size_t n = 0; n < p.nodes.size(); ++n)
    if (std::abs(p.nodes[n][0] - x) < 1e-9 && std::abs(p.nodes[n][1] - y) < 1e-9) return static_cast<int>(n);
  return -1;
}

BoundsResult search(const Problem& p, int triangles) {
  BoundsOptions options;
  options.gap = 0.002;
  options.most_triangles = triangles;
  return find_bounds(p, options);
}

/// Moment of the clay and its load about the foot of the clay, less that of cohesion [N]: Rankine's active pressure is
/// γ z + q − 2 s_u/F.
constexpr double driving = weight * height * height * height / 6 + load * height * height / 2;

/// Returns the factor of a wall that turns about a hinge at the foot of the clay while `resisting` [N] holds it. The
/// velocity (x − y, x − y) of the clay has no shear strain along the principal directions of Rankine's stress, so that
/// this pressure is exact.
double find_exact(double resisting) {
  return cohesion * height * height / (driving - resisting);
}

/// The mechanism lies in the mesh, so that the upper bound is exact. The lower one needs small elements at the hinge:
/// below it the moment grows until the ground turns it.
void expect_exact(const BoundsResult& found, double exact) {
  EXPECT_EQ(found.no_lower, "");
  EXPECT_EQ(found.no_upper, "");
  EXPECT_LE(found.lower, exact * (1 + 1e-6));
  EXPECT_GT(found.lower, exact * 0.88);
  EXPECT_NEAR(found.upper, exact, 2e-4 * exact);
}

TEST(BoundsWalls, CantileverWithAHinge) {
  Problem p = make_retained(0.5);
  add_wall(p, -1).moment = 50e3;
  expect_exact(search(p, 400), find_exact(50e3));
}

/// The lower bound needs small elements at the hinge, above and below it.
TEST(BoundsWalls, SmallElementsProveTheHinge) {
  Problem p = make_retained(0.5);
  add_wall(p, -1).moment = 50e3;
  const int foot = find_node(p, 0, 0);
  for (int i = 0; i < 8; ++i) {
    std::vector<bool> near(p.size());
    for (std::size_t e = 0; e < p.size(); ++e)
      near[e] = std::find(p.triangles[e].begin(), p.triangles[e].end(), foot) != p.triangles[e].end();
    p = refine(p, near);
  }
  const BoundsResult found = search(p, 400);
  expect_exact(found, find_exact(50e3));
  EXPECT_GT(found.lower, 0.99 * find_exact(50e3));
}

TEST(BoundsWalls, StrutAtTheHead) {
  Problem p = make_retained(0.5);
  Wall& wall = add_wall(p, -1);
  wall.moment = 30e3;
  wall.struts.push_back({find_node(p, 0, height), -1, 10e3});
  expect_exact(search(p, 400), find_exact(30e3 + 10e3 * height));
}

/// A wall that hangs on its strength in compression: M ≤ M_p (1 − N/N_p) at the foot.
TEST(BoundsWalls, AxialForceLowersTheMoment) {
  Problem p = make_retained(0.5);
  Wall& wall = add_wall(p, -1);
  wall.moment = 80e3, wall.axial = 100e3;
  wall.line_load = {0, -20e3};
  expect_exact(search(p, 400), find_exact(80e3 * (1 - 20e3 * height / 100e3)));
}

/// The tie of an anchor whose bond lies outside the mechanism, as a load and as a resistance.
TEST(BoundsWalls, BarsHoldTheWall) {
  for (const bool is_reduced : {false, true}) {
    Problem p = make_retained(0.5);
    add_wall(p, -1).moment = 40e3;
    constexpr double level = 1.5, tie = 8e3;
    for (double x = 0; x < 3.9; x += 0.5) {
      const auto find_force = [&](double at) { return at < 2.9 ? tie : tie * (4 - at); };
      p.bars.push_back(
          {find_node(p, x, level), find_node(p, x + 0.5, level), {find_force(x), find_force(x + 0.5)}, is_reduced});
    }
    p.heads.push_back({find_node(p, 0, level), {1, 0}, tie, is_reduced, {}, 0});
    const double held = is_reduced ? tie * level : 0;
    // F (driving − M_p) = s_u H² + T l for a resistance.
    const double exact =
        is_reduced ? (cohesion * height * height + held) / (driving - 40e3) : find_exact(40e3 + tie * level);
    expect_exact(search(p, 400), exact);
  }
}

/// A bar through a wall in the ground holds both sides together: that of a wall without strength changes nothing.
TEST(BoundsWalls, BarsPassThroughWalls) {
  Problem bare = make_columns(divide(0, {{4, 8}}), 4, -2, [](double) { return 0.0; });
  fill(bare, 10e3, 0, 0);
  std::erase_if(bare.sides, [](const Side& s) { return s.holds_normal && !s.holds_along; });
  for (const Edge& edge : list_edges(bare.triangles)) {
    const Vec<2>& a = bare.nodes[static_cast<std::size_t>(edge.from)];
    const Vec<2>& b = bare.nodes[static_cast<std::size_t>(edge.to)];
    if (edge.other < 0 && a[0] > 4 - 1e-9 && b[0] > 4 - 1e-9)  // it is pulled away
      bare.sides.push_back({edge.from, edge.to, false, false, {{{12e3, 0}, {12e3, 0}}}});
  }
  const auto add_bar = [](Problem& p) {
    for (double x = 0; x < 3.9; x += 0.5) {
      const auto find_force = [&](double at) { return 8e3 * std::min({1.0, at, 4 - at}); };
      p.bars.push_back(
          {find_node(p, x, -1), find_node(p, x + 0.5, -1), {find_force(x), find_force(x + 0.5)}, false, 0});
    }
  };
  const auto add_joint = [](Problem& p) {
    Wall& wall = p.walls.emplace_back();
    for (int i = 0; i <= 4; ++i) wall.nodes.push_back(find_node(p, 2, -0.5 * i));
    wall.interface.assign(4, {InterfaceStrength{5e3, 0}, InterfaceStrength{5e3, 0}});
    wall.moment = 1;
  };
  Problem joined = bare, tied = bare;
  add_joint(joined), add_joint(tied), add_bar(tied), add_bar(bare);
  const BoundsResult whole = search(bare, 400), cut = search(joined, 400), held = search(tied, 400);
  EXPECT_GT(held.lower, cut.upper * 1.05);
  EXPECT_LE(held.lower, whole.upper);
  EXPECT_LE(held.lower, held.upper);
}

/// Water of one pressure over everything, in the soil and in the gaps, changes nothing.
TEST(BoundsWalls, PressureOverEverythingChangesNothing) {
  Problem p = make_retained(0.5);
  Wall& wall = add_wall(p, -1);
  wall.moment = 50e3;
  const BoundsResult dry = search(p, 100);
  constexpr double pressure = 30e3;
  for (auto& corners : p.pore_pressure) corners = {pressure, pressure, pressure};
  for (Side& s : p.sides)
    for (Vec<2>& t : s.traction)
      if (t[1] != 0) t[1] -= pressure;
  for (const Edge& edge : list_edges(p.triangles)) {
    const Vec<2>&a = p.nodes[static_cast<std::size_t>(edge.from)], &b = p.nodes[static_cast<std::size_t>(edge.to)];
    if (edge.other >= 0) continue;
    const bool is_floor = a[0] < 1e-9 && b[0] < 1e-9 && std::abs(a[1]) < 1e-9 && std::abs(b[1]) < 1e-9,
               is_face = std::abs(a[0]) < 1e-9 && std::abs(b[0]) < 1e-9;
    const Vec<2> push = is_floor ? Vec<2>{0, -pressure} : Vec<2>{pressure, 0};
    if (is_floor || is_face) p.sides.push_back({edge.from, edge.to, false, false, {push, push}});
  }
  const BoundsResult wet = search(p, 100);
  EXPECT_NEAR(wet.lower, dry.lower, 1e-3);
  EXPECT_NEAR(wet.upper, dry.upper, 1e-4);
}

/// A wall that fails in shear moves forward as a whole: F = 2 s_u H/(q H + γ H²/2 − V).
TEST(BoundsWalls, ShearStrengthIsBracketed) {
  Problem p = make_retained(0.5);
  add_wall(p, -1).shear = 60e3;
  const double exact = 2 * cohesion * height / (load * height + weight * height * height / 2 - 60e3);
  const BoundsResult found = search(p, 400);
  EXPECT_LT(found.lower, exact);
  EXPECT_GT(found.upper, exact);
}

/// A block on a plate, pushed by its side: F = (a + σ tan δ) L/T.
TEST(BoundsWalls, BlockOnItsInterface) {
  Problem p = make_columns(divide(0, {{4, 8}}), 4, -1, [](double) { return 1.0; });
  fill(p, 1e9, 0, 20e3);
  std::erase_if(p.sides, [&](const Side& s) {
    return std::max(p.nodes[static_cast<std::size_t>(s.from)][1], p.nodes[static_cast<std::size_t>(s.to)][1]) > 1e-9;
  });
  constexpr double push = 40e3, adhesion = 5e3, tangent = 0.3;
  for (const Edge& edge : list_edges(p.triangles)) {
    const Vec<2>&a = p.nodes[static_cast<std::size_t>(edge.from)], &b = p.nodes[static_cast<std::size_t>(edge.to)];
    if (edge.other < 0 && a[0] < 1e-9 && b[0] < 1e-9 && a[1] + b[1] > 0)
      p.sides.push_back({edge.from, edge.to, false, false, {{{push, 0}, {push, 0}}}});
  }
  Wall& wall = p.walls.emplace_back();
  for (int i = 0; i <= 8; ++i) wall.nodes.push_back(find_node(p, 0.5 * i, 0));
  wall.interface.assign(8, {InterfaceStrength{adhesion, tangent}, InterfaceStrength{adhesion, tangent}});
  const BoundsResult found = search(p, 100);
  const double exact = (adhesion + 20e3 * tangent) * 4 / push;
  EXPECT_LE(found.lower, exact * (1 + 1e-6));
  EXPECT_GT(found.lower, exact * 0.999);
  EXPECT_NEAR(found.upper, exact, 1e-3 * exact);
}

/// Fields in which somebody has moved or strengthened the wall prove nothing.
TEST(BoundsWalls, ChecksFindWhatWasChanged) {
  Problem p = make_retained(0.5);
  Wall& wall = add_wall(p, -1);
  wall.moment = 30e3;
  wall.struts.push_back({find_node(p, 0, height), -1, 10e3});
  const BoundsResult found = search(p, 100);
  ASSERT_TRUE(check(found.stress_problem, found.stress).holds);
  StressField stress = found.stress;
  stress.struts[0][0] += 100;
  EXPECT_FALSE(check(found.stress_problem, stress).holds);
  Problem weaker = found.stress_problem;
  weaker.walls[0].moment *= 0.95;
  EXPECT_FALSE(check(weaker, found.stress).holds);
  ASSERT_TRUE(check(found.velocity_problem, found.velocity).holds);
  VelocityField velocity = found.velocity;
  velocity.walls[0][0][0][1] += 1e-3;  // the wall is stretched
  EXPECT_FALSE(check(found.velocity_problem, velocity).holds);
  velocity = found.velocity;
  for (auto& ends : velocity.walls[0])
    for (Vec<2>& u : ends) u[0] += 1e-3;  // the wall presses into the soil
  EXPECT_FALSE(check(found.velocity_problem, velocity).holds);
  weaker = found.velocity_problem;
  weaker.walls[0].moment *= 1.1;
  EXPECT_GT(check(weaker, found.velocity).factor, found.upper * 1.01);
}

/// Certificates refuse what they do not cover, whatever the fields.
TEST(BoundsWalls, WallsThatAreNotCoveredProveNothing) {
  Problem p = make_retained(0.5);
  Wall& wall = add_wall(p, -1);
  wall.moment = 50e3;
  EXPECT_TRUE(are_walls_sound(p));
  Problem twice = p;
  twice.walls.push_back(p.walls[0]);
  EXPECT_FALSE(are_walls_sound(twice));
  Problem along = p;
  along.bars.push_back({p.walls[0].nodes[1], p.walls[0].nodes[2], {1e3, 1e3}, false, 0});
  EXPECT_FALSE(are_walls_sound(along));
  Problem beside = p;
  beside.walls[0].struts.push_back({find_node(p, 1, 1), -1, 1e3});
  EXPECT_FALSE(are_walls_sound(beside));
  beside = p;
  beside.heads.push_back({find_node(p, 1, 1), {1, 0}, 1e3, false, {}, 0});
  EXPECT_FALSE(are_walls_sound(beside));
  Problem held = p;
  held.sides.push_back({p.walls[0].nodes[0], p.walls[0].nodes[1], true, false, {}});
  EXPECT_FALSE(are_walls_sound(held));
  const BoundsResult found = search(p, 100);
  held = found.stress_problem;
  held.walls.push_back(held.walls[0]);
  EXPECT_FALSE(check(held, found.stress).holds);
  held = found.velocity_problem;
  held.walls.push_back(held.walls[0]);
  EXPECT_FALSE(check(held, found.velocity).holds);
}

}  // namespace
}  // namespace talus::bounds
