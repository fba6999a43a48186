// SPDX-License-Identifier: MIT
// Slip surfaces that bars cross: closed forms of a block and of a long slope with bars, active and passive, and the
// limits of the force of a bar.

#include "lem/section/bars.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

/// A bar whose bond never governs.
Bar make_bar(const Point& head, const Point& end, double force, bool is_active) {
  Bar bar;
  bar.name = "bar";
  bar.head = head;
  bar.end = end;
  bar.tensile = bar.plate = force;
  bar.bond = 1e6;
  bar.is_active = is_active;
  return bar;
}

/// A vertical cut of the height 6 with its toe at the origin, and a plane through the toe.
struct Wedge {
  double c = 5, phi = 30 * degree, gamma = 20, height = 6, plane = 55 * degree;
  double weight() const { return 0.5 * gamma * height * height / std::tan(plane); }
  double length() const { return height / std::sin(plane); }
  Section section() const {
    return make_section({{-10, 0}, {0, 0}, {0, height}, {30, height}}, make_soil(c, phi / degree, gamma), -10);
  }
  Surface surface() const { return make_polyline({{0, 0}, {height / std::tan(plane), height}}); }
};

const std::vector<Method> by_forces{Method::fellenius, Method::janbu, Method::spencer, Method::morgenstern_price,
                                    Method::corps_2};

TEST(LemSupports, ActiveForceIsALoadOnTheBlock) {
  const Wedge wedge;
  const double force = 40, dip = 15 * degree;
  Section section = wedge.section();
  section.bars = {make_bar({0, 3}, {6 * std::cos(dip), 3 - 6 * std::sin(dip)}, force, true)};
  const double along = force * std::cos(wedge.plane + dip), across = force * std::sin(wedge.plane + dip);
  const double expected =
      (wedge.c * wedge.length() + (wedge.weight() * std::cos(wedge.plane) + across) * std::tan(wedge.phi)) /
      (wedge.weight() * std::sin(wedge.plane) - along);
  for (const Method method : by_forces)
    EXPECT_NEAR(find_factor(Slope(Section(section)), wedge.surface(), method), expected, 1e-6 * expected)
        << to_word(method);
}

TEST(LemSupports, PassiveForceIsDividedByTheFactor) {
  const Wedge wedge;
  const double force = 40, dip = 15 * degree;
  Section section = wedge.section();
  section.bars = {make_bar({0, 3}, {6 * std::cos(dip), 3 - 6 * std::sin(dip)}, force, false)};
  // F W sin θ = c l + W cos θ tan φ + T cos(θ + δ) + T sin(θ + δ) tan φ / F
  const double driving = wedge.weight() * std::sin(wedge.plane);
  const double resisting = wedge.c * wedge.length() + wedge.weight() * std::cos(wedge.plane) * std::tan(wedge.phi) +
                           force * std::cos(wedge.plane + dip);
  const double pressed = force * std::sin(wedge.plane + dip) * std::tan(wedge.phi);
  const double expected = (resisting + std::sqrt(resisting * resisting + 4 * driving * pressed)) / (2 * driving);
  for (const Method method : by_forces)
    EXPECT_NEAR(find_factor(Slope(Section(section)), wedge.surface(), method), expected, 1e-6 * expected)
        << to_word(method);
}

TEST(LemSupports, EarthquakeActsBesideTheBars) {
  const Wedge wedge;
  const double force = 40, k = 0.1;
  Section section = wedge.section();
  section.horizontal_acceleration = k;
  section.bars = {make_bar({0, 3}, {6, 3}, force, true)};
  const double push = k * wedge.weight() - force;
  const double expected =
      (wedge.c * wedge.length() +
       (wedge.weight() * std::cos(wedge.plane) - push * std::sin(wedge.plane)) * std::tan(wedge.phi)) /
      (wedge.weight() * std::sin(wedge.plane) + push * std::cos(wedge.plane));
  for (const Method method : by_forces)
    EXPECT_NEAR(find_factor(Slope(Section(section)), wedge.surface(), method), expected, 1e-6 * expected)
        << to_word(method);
}

TEST(LemSupports, DirectionOfTheForce) {
  const Wedge wedge;
  const double force = 40, angle = wedge.plane;
  // Horizontal bar: the angle of its force with the plane, along and across it.
  const std::vector<std::pair<BarDirection, double>> turned{{BarDirection::axial, angle},
                                                            {BarDirection::tangent, 0},
                                                            {BarDirection::bisector, angle / 2},
                                                            {BarDirection::normal, angle - 90 * degree}};
  for (const auto& [direction, turn] : turned) {
    Section section = wedge.section();
    section.bars = {make_bar({0, 3}, {6, 3}, force, true)};
    section.bars[0].direction = direction;
    const double expected =
        (wedge.c * wedge.length() + (wedge.weight() * std::cos(angle) + force * std::sin(turn)) * std::tan(wedge.phi)) /
        (wedge.weight() * std::sin(angle) - force * std::cos(turn));
    EXPECT_NEAR(find_factor(Slope(Section(section)), wedge.surface(), Method::spencer), expected, 1e-6 * expected);
  }
}

TEST(LemSupports, LongSlopeWithNails) {
  // Nails every 2 m across a slide of the depth h: their force is spread over the slope. The ends are 0.1 % of it.
  const double c = 2, phi = 30 * degree, gamma = 19, h = 1.5, beta = 28 * degree, length = 20000, force = 6,
               dip = 20 * degree, spacing = 50, rise = std::tan(beta);
  const auto make = [&](bool is_active) {
    Section section = make_section({{-20, 0}, {0, 0}, {length, length * rise}, {length + 20, length * rise}},
                                   make_soil(c, 30, gamma), -10);
    for (double x = 20 + spacing / 2; x < length - 20; x += spacing)
      section.bars.push_back(
          make_bar({x, x * rise}, {x + 6 * std::cos(dip), x * rise - 6 * std::sin(dip)}, force, is_active));
    return section;
  };
  const Surface surface = make_polyline(
      {{5, 5 * rise}, {10, 10 * rise - h}, {length - 10, (length - 10) * rise - h}, {length - 5, (length - 5) * rise}});
  // Per metre of the base.
  const double weight = gamma * h * std::cos(beta), pull = force / spacing * std::cos(beta);
  const double along = pull * std::cos(beta + dip), across = pull * std::sin(beta + dip);
  const double active = (c + (weight * std::cos(beta) + across) * std::tan(phi)) / (weight * std::sin(beta) - along);
  const double resisting = c + weight * std::cos(beta) * std::tan(phi) + along, driving = weight * std::sin(beta);
  const double passive =
      (resisting + std::sqrt(resisting * resisting + 4 * driving * across * std::tan(phi))) / (2 * driving);
  EXPECT_NEAR(find_factor(Slope(make(true)), surface, Method::janbu, 1000), active, 0.001 * active);
  EXPECT_NEAR(find_factor(Slope(make(false)), surface, Method::janbu, 1000), passive, 0.001 * passive);
}

/// Pulls of one bar on the wedge.
std::vector<BarPull> find_pulls(const Section& section, const Surface& surface) {
  const Slope slope{Section(section)};
  const CutSurface cut = cut_surface(slope, surface, 50, report_only());
  EXPECT_EQ(cut.refusal, Refusal::none);
  return cut.pulls;
}

TEST(LemSupports, TensionPullOutAndStripping) {
  const Wedge wedge;
  Section section = wedge.section();
  Bar bar = make_bar({0, 3}, {6, 3}, 40, false);
  const double crossing = 3 / std::tan(wedge.plane);
  bar.bond = 10, bar.tensile = 100, bar.plate = 50;
  section.bars = {bar};
  auto pulls = find_pulls(section, wedge.surface());
  ASSERT_EQ(pulls.size(), 1u);
  EXPECT_NEAR(pulls[0].distance, crossing, 1e-9);
  EXPECT_NEAR(pulls[0].behind, 10 * (6 - crossing), 1e-9);
  EXPECT_NEAR(pulls[0].front, 50 + 10 * crossing, 1e-9);
  EXPECT_NEAR(pulls[0].resistance, 10 * (6 - crossing), 1e-9);
  EXPECT_EQ(pulls[0].limit, BarLimit::pull_out);
  section.bars[0].plate = 0;
  pulls = find_pulls(section, wedge.surface());
  EXPECT_NEAR(pulls[0].resistance, 10 * crossing, 1e-9);
  EXPECT_EQ(pulls[0].limit, BarLimit::stripping);
  section.bars[0].tensile = 5;
  EXPECT_EQ(find_pulls(section, wedge.surface())[0].limit, BarLimit::tension);
  // A free length has no bond.
  section.bars[0].tensile = 100, section.bars[0].plate = 30, section.bars[0].free_length = 4;
  pulls = find_pulls(section, wedge.surface());
  EXPECT_NEAR(pulls[0].behind, 20, 1e-9);
  EXPECT_NEAR(pulls[0].front, 30, 1e-9);
  // The mass stretches a prestressed bar to its resistance.
  section.bars[0].is_active = true;
  for (const double prestress : {0.0, 12.0, 500.0}) {
    section.bars[0].prestress = prestress;
    pulls = find_pulls(section, wedge.surface());
    EXPECT_EQ(pulls[0].limit, BarLimit::pull_out);
    EXPECT_DOUBLE_EQ(pulls[0].force(), 20);
    EXPECT_DOUBLE_EQ(pulls[0].prestress, std::min(prestress, 20.0));
  }
}

TEST(LemSupports, BarThatEndsInFrontOfTheSurfaceHasNoForce) {
  const Wedge wedge;
  Section section = wedge.section();
  const double crossing = 3 / std::tan(wedge.plane);
  section.bars = {make_bar({0, 3}, {crossing - 0.01, 3}, 40, false)};
  EXPECT_TRUE(find_pulls(section, wedge.surface()).empty());
  section.bars[0].end[0] = crossing + 0.01;
  EXPECT_EQ(find_pulls(section, wedge.surface()).size(), 1u);
}

TEST(LemSupports, BarThatCrossesTwiceHoldsWhereItIsPulled) {
  // A long flat bar leaves a deep mass and enters it again beyond its lowest point: there the slide shortens it.
  Section section = make_section({{0, 10}, {20, 10}, {40, 0}, {60, 0}}, make_soil(10, 20, 19), -20);
  const Slope bare{Section(section)};
  const Surface circle = make_circle(bare, {30, 18}, 20);
  Bar bar = make_bar({5, 4}, {48, -1}, 100, false);
  bar.plate = 0, bar.bond = 1;
  section.bars = {bar};
  const auto pulls = find_pulls(section, circle);
  ASSERT_EQ(pulls.size(), 1u);
  EXPECT_LT(pulls[0].at[0], 30);
  // The force points to the part in stable soil, towards the head.
  EXPECT_LT(pulls[0].direction[0], 0);
  // The part in the mass is that between the crossings.
  EXPECT_LT(pulls[0].front, 43.3 - pulls[0].behind);
}

TEST(LemSupports, BarAcrossATensionCrackDoesNotCount) {
  const Wedge wedge;
  Section section = wedge.section();
  section.crack = TensionCrack{3, 0, false};
  // The plane is 3 m below the ground at x = 2.1. One bar meets the crack above, the other the plane below its bottom.
  section.bars = {make_bar({0, 4.5}, {8, 4.5}, 30, false), make_bar({0, 1.5}, {8, 1.5}, 30, false)};
  const auto pulls = find_pulls(section, wedge.surface());
  ASSERT_EQ(pulls.size(), 1u);
  EXPECT_EQ(pulls[0].bar, 1);
  // A head behind the crack is not in the mass.
  section.bars = {make_bar({3, 6}, {3, 2}, 30, false)};
  EXPECT_TRUE(find_pulls(section, wedge.surface()).empty());
}

TEST(LemSupports, EndAnchoredBoltHoldsTheSameAllAlong) {
  const Wedge wedge;
  Section section = wedge.section();
  Bar bar = make_bar({0, 3}, {2.2, 3}, 40, true);
  bar.hold = BarHold::end_anchor;
  section.bars = {bar};
  const auto pulls = find_pulls(section, wedge.surface());
  ASSERT_EQ(pulls.size(), 1u);
  EXPECT_DOUBLE_EQ(pulls[0].resistance, 40);
}

TEST(LemSupports, BondGrowsWithOverburdenLessPorePressure) {
  Section section = make_section({{0, 10}, {50, 10}}, make_soil(5, 30, 20), 0, 10);
  section.water_table = {{0, 8}, {50, 8}};
  Bar bar = make_bar({10, 5}, {30, 5}, 1e6, false);
  bar.bond = 0, bar.bond_factor = 0.5;
  // σ'_v = 5 · 20 - 3 · 10 at the bar, which is as long as 20.
  EXPECT_NEAR(make_bar_diagram(Slope(Section(section)), bar).find_part(0, 20), 0.5 * 70 * 20, 1e-6);
  // With the depth along an inclined bar the bond grows linearly: its sum is that of the middle.
  section.water_table.clear();
  bar.head = {10, 10}, bar.end = {26, -2};
  section.base = -10;
  section.regions = {make_region_below(section, 0, section.ground)};
  EXPECT_NEAR(make_bar_diagram(Slope(Section(section)), bar).find_part(0, 10), 0.5 * 20 * 3 * 10, 1e-6);
}

// Ito and Matsui (1975).

TEST(PilePressure, NeedsPlasticSoilAndFallsWithTheSpacing) {
  // φ = 0: p = c [D1 (3 ln(D1/D2) + (D1 - D2)/D2 tan(π/8)) - 2 (D1 - D2)] + γz (D1 - D2), D1 = 3, D2 = 2.
  const double expected = 20 * (3 * (3 * std::log(1.5) + 0.5 * std::tan(22.5 * degree)) - 2) + 100;
  EXPECT_NEAR(compute_pile_pressure({20, 0}, 100, 3, 1), expected, 1e-9 * expected);
  // A small friction angle tends to it.
  EXPECT_NEAR(compute_pile_pressure({20, 1e-3}, 100, 3, 1), expected, 0.01 * expected);
  double last = 1e9;
  for (const double spacing : {1.6, 2.4, 3.2, 4.8}) {
    const double share = compute_pile_pressure({10, std::tan(20 * degree)}, 100, spacing, 0.8) / spacing;
    EXPECT_LT(share, last);
    last = share;
  }
}

}  // namespace
}  // namespace talus::lem
