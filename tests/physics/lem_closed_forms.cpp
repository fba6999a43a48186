// SPDX-License-Identifier: MIT
// Slip surfaces with a closed-form factor of safety.

#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

/// A long even slope that rises to the right, with level ground at both ends.
struct LongSlope {
  double inclination = 0;  ///< β [rad]
  double length = 0;       ///< horizontal [m]
  std::vector<Point> ground() const {
    const double height = length * std::tan(inclination);
    return {{-20, 0}, {0, 0}, {length, height}, {length + 20, height}};
  }
  /// Parallel to the ground in the depth h (vertical), with short ends up to it.
  Surface surface(double depth) const {
    const double rise = std::tan(inclination), margin = 5 * depth;
    return make_polyline({{margin, margin * rise},
                          {2 * margin, 2 * margin * rise - depth},
                          {length - 2 * margin, (length - 2 * margin) * rise - depth},
                          {length - margin, (length - margin) * rise}});
  }
};

const std::vector<Method> by_forces{Method::fellenius, Method::janbu, Method::spencer, Method::morgenstern_price};

TEST(LemInfiniteSlope, DryWithCohesion) {
  const LongSlope slope{25 * degree, 2000};
  const double c = 5, phi = 30 * degree, gamma = 19, h = 2, beta = slope.inclination;
  const Slope section(make_section(slope.ground(), make_soil(c, 30, gamma), -10));
  const double expected = c / (gamma * h * std::sin(beta) * std::cos(beta)) + std::tan(phi) / std::tan(beta);
  // The ends make 1 % of the length.
  for (const Method method : by_forces)
    EXPECT_NEAR(find_factor(section, slope.surface(h), method, 400), expected, 0.006 * expected) << to_word(method);
}

TEST(LemInfiniteSlope, WithoutCohesionIsTangentOverTangent) {
  // Duncan and Wright; tan 45° / tan 27.18° for the upstream face of Talbingo dam: 1.9475. A shallow arc comes near to
  // it from above.
  const LongSlope slope{std::atan(162.0 / 315.5), 315.5};
  const Slope section(make_section(slope.ground(), make_soil(0, 45, 20.4), -10));
  const double expected = std::tan(45 * degree) / std::tan(slope.inclination);
  EXPECT_NEAR(expected, 1.9475, 1e-4);
  for (const Method method : {Method::fellenius, Method::bishop, Method::janbu, Method::spencer}) {
    const double chord = 250 / std::cos(slope.inclination), sag = 0.3;
    const double radius = (chord * chord / 4 + sag * sag) / (2 * sag);
    const Point middle{155, 155 * std::tan(slope.inclination)};
    const Surface arc = make_arc({middle[0] - (radius - sag) * std::sin(slope.inclination),
                                  middle[1] + (radius - sag) * std::cos(slope.inclination)},
                                 radius, 30, 280);
    const double found = find_factor(section, arc, method);
    EXPECT_GE(found, expected * (1 - 1e-9)) << to_word(method);
    EXPECT_NEAR(found, expected, 2e-4) << to_word(method);
  }
}

/// u = γ_w h cos²β in the depth h: seepage parallel to the ground, whose surface is the ground.
PressureGrid make_parallel_seepage(const LongSlope& slope, double deepest) {
  const double rise = std::tan(slope.inclination),
               u = 9.81 * deepest * std::cos(slope.inclination) * std::cos(slope.inclination);
  const double from = 0, to = slope.length;
  return {
      {{from, 0}, {to, to * rise}, {to, to * rise - deepest}, {from, -deepest}}, {{0, 1, 2}, {0, 2, 3}}, {0, 0, u, u}};
}

TEST(LemInfiniteSlope, SeepageParallelToTheSlope) {
  const LongSlope slope{18 * degree, 2000};
  const double c = 4, phi = 28 * degree, gamma = 20, h = 2, beta = slope.inclination, cosine = std::cos(beta);
  Section section = make_section(slope.ground(), make_soil(c, 28, gamma), -10);
  section.pressure_grid = make_parallel_seepage(slope, 8);
  const double expected =
      (c + (gamma - 9.81) * h * cosine * cosine * std::tan(phi)) / (gamma * h * std::sin(beta) * cosine);
  for (const Method method : {Method::janbu, Method::spencer, Method::morgenstern_price, Method::fellenius})
    EXPECT_NEAR(find_factor(Slope{Section(section)}, slope.surface(h), method, 400), expected, 0.006 * expected)
        << to_word(method);
  // The same pore pressure as a ratio of the weight above.
  section.pressure_grid.reset();
  section.soils[0].pore_pressure_ratio = 9.81 * cosine * cosine / gamma;
  for (const Method method : by_forces)
    EXPECT_NEAR(find_factor(Slope{Section(section)}, slope.surface(h), method, 400), expected, 0.006 * expected)
        << to_word(method);
}

// Culmann's plane from the toe; Baker 2001: 1.352 at 49.5°, RocPlane 1.351. A wedge without inner freedom: all methods
// agree.
TEST(LemPlane, Culmann) {
  const double angle = 49.5 * degree, height = 10, c = 30, phi = 30 * degree, gamma = 20;
  const Slope slope(make_section({{-5, 0}, {0, 0}, {2.5, height}, {40, height}}, make_soil(c, 30, gamma), -5));
  const double top = height / std::tan(angle), weight = gamma * 0.5 * height * (top - 2.5);
  const double expected =
      (c * height / std::sin(angle) + weight * std::cos(angle) * std::tan(phi)) / (weight * std::sin(angle));
  EXPECT_NEAR(expected, 1.352, 5e-4);
  const Surface plane = make_polyline({{0, 0}, {top, height}});
  for (const Method method : {Method::fellenius, Method::janbu, Method::janbu_corrected, Method::spencer,
                              Method::morgenstern_price, Method::morgenstern_price_constant})
    EXPECT_NEAR(find_factor(slope, plane, method, 30), expected, 1e-6) << to_word(method);
  CutSurface cut = cut_surface(slope, plane, 30, report_only());
  EXPECT_EQ(solve(slope, cut, Method::bishop, report_only(), false).refusal, Refusal::moment_axis);
}

// Priest 1993: a block on a plane of 30° with a crack, 3.75 m of water in it and u falling to zero at the toe: 1.049.
TEST(LemPlane, BlockWithWaterInItsCrack) {
  Section section = make_section({{-10, 0}, {0, 0}, {17, 30}, {80, 30}}, make_soil(20, 30, 25), -5);
  section.crack = TensionCrack{15, 3.75};
  const double u = 9.81 * 3.75;
  const double angle = 30 * degree, end = 15 / std::tan(angle), area = 0.5 * 17 * 30 + (end - 17) * 30 - 0.5 * end * 15;
  section.pressure_grid =
      PressureGrid{{{0, -10}, {end, -10}, {end, 40}, {0, 40}}, {{0, 1, 2}, {0, 2, 3}}, {0, u, u, 0}};
  const double weight = 25 * area, uplift = 0.5 * u * 30, thrust = 0.5 * u * 3.75;
  const double expected = (20 * 30 + (weight * std::cos(angle) - uplift - thrust * std::sin(angle)) * std::tan(angle)) /
                          (weight * std::sin(angle) + thrust * std::cos(angle));
  EXPECT_NEAR(expected, 1.0483, 3e-4);
  const Surface plane = make_polyline({{0, 0}, {30 / std::tan(angle), 30}});
  const Slope slope{std::move(section)};
  const CutSurface cut = cut_surface(slope, plane, 50, report_only());
  EXPECT_NEAR(cut.slices.back().right, end, 1e-9);
  EXPECT_NEAR(cut.area, area, 1e-9);
  EXPECT_NEAR(cut.crack_thrust_level, 15 + 1.25, 1e-9);
  for (const Method method : {Method::janbu, Method::spencer, Method::morgenstern_price})
    EXPECT_NEAR(find_factor(slope, plane, method, 50), expected, 1e-6) << to_word(method);
  // In Fellenius' method the thrust drives the mass and does not relieve the base.
  EXPECT_NEAR(
      find_factor(slope, plane, Method::fellenius, 50),
      expected + thrust * std::sin(angle) * std::tan(angle) / (weight * std::sin(angle) + thrust * std::cos(angle)),
      1e-6);
}

TEST(LemPlane, EarthquakeAndVerticalAcceleration) {
  const double angle = 35 * degree, height = 12, c = 12, phi = 32 * degree, gamma = 18, kh = 0.2, kv = -0.1;
  Section section = make_section({{-5, 0}, {0, 0}, {6, height}, {60, height}}, make_soil(c, 32, gamma), -5);
  section.horizontal_acceleration = kh;
  section.vertical_acceleration = kv;
  const double top = height / std::tan(angle), weight = gamma * 0.5 * height * (top - 6);
  const double down = weight * (1 + kv), side = weight * kh;
  const double expected =
      (c * height / std::sin(angle) + (down * std::cos(angle) - side * std::sin(angle)) * std::tan(phi)) /
      (down * std::sin(angle) + side * std::cos(angle));
  const Slope slope{std::move(section)};
  for (const Method method : {Method::fellenius, Method::janbu, Method::spencer})
    EXPECT_NEAR(find_factor(slope, make_polyline({{0, 0}, {top, height}}), method, 20), expected, 1e-6)
        << to_word(method);
}

TEST(LemPlane, Surcharge) {
  const double angle = 40 * degree, height = 8, c = 15, phi = 25 * degree, gamma = 19;
  Section section = make_section({{-5, 0}, {0, 0}, {4, height}, {60, height}}, make_soil(c, 25, gamma), -5);
  section.surcharges = {{{{5, 20}, {7, 40}}}, {{{5, 10}, {6, 10}}}};  // 60 and 10 kN
  const double top = height / std::tan(angle), down = gamma * 0.5 * height * (top - 4) + 70;
  const double expected =
      (c * height / std::sin(angle) + down * std::cos(angle) * std::tan(phi)) / (down * std::sin(angle));
  const Slope slope{std::move(section)};
  for (const Method method : {Method::fellenius, Method::janbu, Method::spencer})
    EXPECT_NEAR(find_factor(slope, make_polyline({{0, 0}, {top, height}}), method, 20), expected, 1e-6)
        << to_word(method);
}

// A pull at the crest, out of the slope or into it, and a push on the foot of a vertical face: forces on a rigid block.
TEST(LemPlane, HorizontalLoads) {
  const double angle = 40 * degree, height = 8, c = 15, phi = 25 * degree, gamma = 19;
  const double top = height / std::tan(angle);
  struct Loads {
    double crest, face, lift;  // to larger x; up [kPa]
  };
  for (const Loads& loads : {Loads{-12, 0, 0}, Loads{9, 0, 0}, Loads{-12, 10, 0}, Loads{4, 10, -3}}) {
    Section section = make_section({{-5, 0}, {0, 0}, {0, height}, {60, height}}, make_soil(c, 25, gamma), -5);
    section.surcharges = {{{{3, 10, loads.crest}, {7, 10, loads.crest}}}};
    section.face_loads = {{0, 1, 4, {loads.face, loads.lift}}};
    const double down = gamma * 0.5 * height * top + 40 - 3 * loads.lift, out = -4 * loads.crest - 3 * loads.face;
    const double expected =
        (c * height / std::sin(angle) + (down * std::cos(angle) - out * std::sin(angle)) * std::tan(phi)) /
        (down * std::sin(angle) + out * std::cos(angle));
    const Slope slope{std::move(section)};
    for (const Method method : {Method::fellenius, Method::janbu, Method::spencer})
      EXPECT_NEAR(find_factor(slope, make_polyline({{0, 0}, {top, height}}), method, 40), expected, 1e-6 * expected)
          << to_word(method) << loads.crest;
  }
}

// A pond is a load normal to the ground: the same pressures as tractions on a face and on a step give its factors.
TEST(LemPond, IsATractionNormalToTheGround) {
  const double gamma = 9.81;
  Section pond = make_section({{-20, 0}, {0, 0}, {12, 9}, {40, 9}}, make_soil(10, 25, 19), -5);
  pond.water_table = {{-20, 6}, {40, 6}};
  Section loaded = pond;
  for (Soil& soil : pond.soils) soil.undrained = true;
  for (Soil& soil : loaded.soils) soil.undrained = true;
  loaded.water_table.clear();
  loaded.soils[0].unit_weight = pond.soils[0].unit_weight;
  loaded.surcharges = {{{{-20, 6 * gamma, 0}, {0, 6 * gamma, 0}}}, {{{0, 6 * gamma, 6 * gamma * 0.75}, {8, 0, 0}}}};
  const Slope a{std::move(pond)}, b{std::move(loaded)};
  for (const double radius : {17.0, 19.0, 22.0}) {
    const Surface arc = make_circle(a, {2, 17.5}, radius);
    for (const Method method : all_methods)
      EXPECT_NEAR(find_factor(a, arc, method, 400), find_factor(b, arc, method, 400), 2e-5) << to_word(method);
  }
}

// φ = 0: F = c R² θ / moment of the weight, by integration; a slope of 45° and an arc through its toe.
TEST(LemUndrained, ArcByIntegration) {
  const double height = 10, c = 40, gamma = 18;
  const Point centre{2, 18};
  const double radius = std::hypot(centre[0], centre[1]);
  const Slope slope(make_section({{-30, 0}, {0, 0}, {10, height}, {60, height}}, make_soil(c, 0, gamma), -20));
  const double to = centre[0] + std::sqrt(radius * radius - (centre[1] - height) * (centre[1] - height));
  double moment = 0;
  const int steps = 2000000;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * to / steps, d = x - centre[0];
    const double depth = std::min(x, height) - (centre[1] - std::sqrt(radius * radius - d * d));
    moment += gamma * depth * d * to / steps;
  }
  const double angle = std::asin((to - centre[0]) / radius) + std::asin(centre[0] / radius);
  const double expected = c * radius * radius * angle / moment;
  for (const Method method : {Method::fellenius, Method::bishop})
    EXPECT_NEAR(find_factor(slope, make_arc(centre, radius, 0, to), method, 400), expected, 2e-4 * expected);
}

// The same arc in a clay whose strength grows with depth: the sum of c R over the arc, by integration.
TEST(LemUndrained, CohesionGrowingWithDepth) {
  Soil soil = make_soil(15, 0, 18);
  soil.cohesion_gradient = 3;
  soil.cohesion_level = 6;
  const Point centre{2, 18};
  const double radius = std::hypot(centre[0], centre[1]), to = centre[0] + std::sqrt(radius * radius - 64);
  const std::vector<Point> ground{{-30, 0}, {0, 0}, {10, 10}, {60, 10}};
  const double even = find_factor(Slope(make_section(ground, make_soil(15, 0, 18), -20)),
                                  make_arc(centre, radius, 0, to), Method::bishop, 400);
  const double from_angle = -std::asin(centre[0] / radius), to_angle = std::asin((to - centre[0]) / radius);
  double sum = 0;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double angle = from_angle + (i + 0.5) * (to_angle - from_angle) / steps;
    sum += (15 + 3 * std::max(0.0, 6 - (centre[1] - radius * std::cos(angle)))) / steps;
  }
  EXPECT_NEAR(find_factor(Slope(make_section(ground, soil, -20)), make_arc(centre, radius, 0, to), Method::bishop, 400),
              even * sum / 15, 1e-4);
}

}  // namespace
}  // namespace talus::lem
