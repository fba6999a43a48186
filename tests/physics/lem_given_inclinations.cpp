// SPDX-License-Identifier: MIT
// Force-equilibrium methods with given inclinations of the interslice forces.

#include "lem/slices/mass.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

constexpr std::array given{Method::corps_1, Method::corps_2, Method::lowe_karafiath, Method::modified_swedish};

const std::vector<Point> acads{{0, 25}, {30, 25}, {50, 35}, {90, 35}};

// On a plane the forces along it and across it are those of the whole mass, whatever acts between the slices.
TEST(LemGivenInclinations, APlaneHasTheFactorOfTheWholeMass) {
  const Section section = make_section(acads, make_soil(6, 22, 19), 20);
  const Slope slope{Section(section)};
  Surface plane;
  plane.line = {{30, 25}, {60, 35}};
  plane.from = 30, plane.to = 60;
  const double alpha = std::atan2(10, 30), length = std::hypot(30, 10), weight = 19e3 * 0.5 * 10 * 10;
  const double exact = (6e3 * length + weight * std::cos(alpha) * std::tan(22 * degree)) / (weight * std::sin(alpha));
  for (const Method method : given)
    EXPECT_NEAR(find_factor(slope, plane, method, 60), exact, 1e-6 * exact) << to_word(method);
}

// With Spencer's inclination the forces of Spencer close, and so does the factor.
TEST(LemGivenInclinations, SpencersInclinationGivesSpencersFactor) {
  const Slope slope{make_section(acads, make_soil(3, 19.6, 20), 20)};
  const Surface circle = make_arc({29.543601, 53.63679}, 28.640427, 30, 51.290879);
  CutSurface cut = cut_surface(slope, circle, 60, {});
  const Solution spencer = solve(slope, cut, Method::spencer, {}, false);
  Mass mass;
  mass.set(slope, cut, 0);
  for (Wedge& wedge : mass.wedges) wedge.ratio = spencer.lambda;
  EXPECT_NEAR(solve_forces(mass, 1).factor, spencer.factor, 1e-6);
}

// Published on circles of other programs' own searches (ACADS 1(a)): 0.99 with forces parallel to the ground, 0.987 by
// Lowe and Karafiath; this circle is the critical one of Spencer.
TEST(LemGivenInclinations, AcadsIsThePublishedOne) {
  const Slope slope{make_section(acads, make_soil(3, 19.6, 20), 20)};
  const Surface circle = make_arc({29.543601, 53.63679}, 28.640427, 30, 51.290879);
  EXPECT_NEAR(find_factor(slope, circle, Method::corps_2, 100), 0.99, 0.01);
  EXPECT_NEAR(find_factor(slope, circle, Method::lowe_karafiath, 100), 0.987, 0.01);
}

// Sliding to the right is sliding to the left in a mirror.
TEST(LemGivenInclinations, TheMirroredSlopeHasTheSameFactor) {
  const std::vector<Point> mirrored{{-90, 35}, {-50, 35}, {-30, 25}, {0, 25}};
  const Slope left{make_section(acads, make_soil(3, 19.6, 20), 20)};
  const Slope right{make_section(mirrored, make_soil(3, 19.6, 20), 20)};
  const Surface one = make_arc({29.543601, 53.63679}, 28.640427, 30, 51.290879);
  const Surface other = make_arc({-29.543601, 53.63679}, 28.640427, -51.290879, -30);
  for (const Method method : given)
    EXPECT_NEAR(find_factor(left, one, method, 60), find_factor(right, other, method, 60), 1e-6) << to_word(method);
}

}  // namespace
}  // namespace talus::lem
