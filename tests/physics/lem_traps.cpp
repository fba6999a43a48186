// SPDX-License-Identifier: MIT
// One test for each known numerical trap of the methods of slices.

#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

// Pruška 2003: 14 m in 10 m, c = 5 kPa, φ = 10°: the critical arc is cut at the toe, where its circle continues below
// the level ground.
TEST(LemCutArc, EndsAtTheToe) {
  const Slope slope(make_section({{0, 8}, {15, 8}, {25, 22}, {40, 22}}, make_soil(5, 10, 18), 0));
  const Surface arc = make_arc({8.126507, 27.89539}, 21.049263, 15, 28.333334);
  CutSurface cut = cut_surface(slope, arc, 100, report_only());
  EXPECT_TRUE(cut.cut_at_toe);
  ASSERT_EQ(cut.warnings.size(), 1u);
  EXPECT_TRUE(cut.slides_left);
  EXPECT_DOUBLE_EQ(cut.slices.front().left, 15);
  EXPECT_GT(cut.slices.front().alpha(), 0.3);  // falls outwards to its very end
  EXPECT_NEAR(find_factor(slope, arc, Method::bishop), 0.341, 0.001);
  EXPECT_NEAR(find_factor(slope, arc, Method::spencer), 0.3404, 0.001);
  // The whole circle comes out of the ground far before the toe.
  const Surface whole = make_circle(slope, {8.126507, 27.89539}, 21.049263);
  EXPECT_NEAR(whole.from, 1.25, 0.01);
  EXPECT_FALSE(cut_surface(slope, whole, 100, report_only()).cut_at_toe);
}

TEST(LemCutArc, MirroredEndsAtTheToe) {
  const Slope slope(make_section({{-40, 22}, {-25, 22}, {-15, 8}, {0, 8}}, make_soil(5, 10, 18), 0));
  const CutSurface cut =
      cut_surface(slope, make_arc({-8.126507, 27.89539}, 21.049263, -28.333334, -15), 100, report_only());
  EXPECT_TRUE(cut.cut_at_toe);
  EXPECT_FALSE(cut.slides_left);
  EXPECT_GT(cut.slices.back().alpha(), 0.3);
}

// Spencer's equations can have two roots. On arcs with steep passive ends that with a negative λ, in which the lower
// part hangs on the upper, has normal forces that explode there. Circles in the homogeneous slopes of Fredlund and
// Krahn 1977 and of Griffiths and Lane 1999.
TEST(LemSpuriousBranch, PositiveForcesBetweenTheSlices) {
  const Slope krahn(make_section({{0, 60}, {60, 60}, {140, 20}, {180, 20}}, make_soil(600, 20, 120), 0, 62.4));
  const Slope lane(make_section({{0, 50}, {60, 50}, {160, 0}, {260, 0}}, make_soil(312.5, 20, 125), -25, 62.4));
  struct Trap {
    const Slope* slope = nullptr;
    Point centre{};
    double radius = 0;
  };
  for (const Trap& trap : {Trap{&krahn, {119.090, 43.741}, 26.332}, Trap{&krahn, {104.895, 58.528}, 40.700},
                           Trap{&lane, {91.465, 44.587}, 19.935}}) {
    const Surface arc = make_circle(*trap.slope, trap.centre, trap.radius);
    CutSurface cut = cut_surface(*trap.slope, arc, 60, Checks{});
    const Solution spencer = solve(*trap.slope, cut, Method::spencer, Checks{}, false);
    const Solution constant = solve(*trap.slope, cut, Method::morgenstern_price_constant, Checks{}, false);
    const Solution bishop = solve(*trap.slope, cut, Method::bishop, Checks{}, false);
    EXPECT_EQ(spencer.refusal, Refusal::none) << name_refusal(spencer.refusal);
    EXPECT_GT(spencer.lambda, 0.05);
    EXPECT_NEAR(spencer.factor, bishop.factor, 0.01 * bishop.factor);
    // Another formulation of the same forces, solved in another way.
    EXPECT_NEAR(constant.factor, spencer.factor, 1e-8 * spencer.factor);
    EXPECT_NEAR(constant.lambda, spencer.lambda, 1e-7);
  }
}

/// Passive ends so steep that m_α falls to nothing are refused, and counted as that.
TEST(LemSteepToe, IsRefused) {
  Section section = make_section({{0, 0}, {20, 0}, {30, 10}, {60, 10}}, make_soil(1, 40, 20), -30);
  section.horizontal_acceleration = 0.4;
  const Slope slope(std::move(section));
  const Surface deep = make_arc({27, 3}, 16.5, 27 - std::sqrt(16.5 * 16.5 - 9), 27 + std::sqrt(16.5 * 16.5 - 49));
  // Its upper end is above the centre: no lower arc goes there.
  EXPECT_EQ(cut_surface(slope, deep, 50, Checks{}).refusal, Refusal::outside);
  const Surface steep = make_circle(slope, {27, 11}, 26);
  CutSurface cut = cut_surface(slope, steep, 50, Checks{});
  ASSERT_EQ(cut.refusal, Refusal::none);
  const Solution refused = solve(slope, cut, Method::bishop, Checks{}, false);
  EXPECT_EQ(refused.refusal, Refusal::m_alpha);
  EXPECT_EQ(refused.factor, 0);
  EXPECT_LT(refused.smallest_m_alpha, 0.2);
  EXPECT_GT(solve(slope, cut, Method::bishop, report_only(), false).factor, 0);
  Checks limited;
  limited.smallest_m_alpha = 0;
  limited.steepest_toe = 25 * degree;  // 45° - φ/2
  EXPECT_EQ(solve(slope, cut, Method::bishop, limited, false).refusal, Refusal::steep_toe);
}

TEST(LemRefusals, GiveTheReason) {
  const Slope slope(make_section({{0, 0}, {20, 0}, {30, 10}, {60, 10}}, make_soil(10, 30, 20), -5));
  const auto refuse = [&](const Surface& surface, const Checks& checks) {
    return cut_surface(slope, surface, 30, checks).refusal;
  };
  Checks checks;
  checks.smallest_depth = 1;
  EXPECT_EQ(refuse(make_polyline({{20, 0}, {25, 4.5}, {30, 10}}), checks), Refusal::too_shallow);
  EXPECT_EQ(refuse(make_polyline({{20, 0}, {26, -7}, {35, 10}}), checks), Refusal::below_base);
  EXPECT_EQ(refuse(make_polyline({{20, 0}, {26, 3}, {35, 9}}), checks), Refusal::outside);
  EXPECT_EQ(refuse(make_polyline({{18, 0}, {22, 3}, {35, 10}}), checks), Refusal::outside);  // above the ground
  EXPECT_EQ(refuse(make_polyline({{20, 0}, {19, -1}, {35, 10}}), checks), Refusal::outside);
  EXPECT_EQ(refuse(make_arc({22, 20}, 22, 10, 40), checks), Refusal::outside);
  EXPECT_EQ(refuse(make_polyline({{-5, 0}, {19, -1}, {35, 10}}), checks), Refusal::outside);
  // Below the base a circle is cut level, or refused.
  const Surface deep = make_circle(slope, {22, 20}, 26);
  EXPECT_EQ(refuse(deep, checks), Refusal::none);
  const CutSurface cut = cut_surface(slope, deep, 30, checks);
  EXPECT_TRUE(cut.composite);
  for (const Slice& slice : cut.slices) EXPECT_GE(std::min(slice.base_left[1], slice.base_right[1]), -5 - 1e-12);
  checks.composite = false;
  EXPECT_EQ(refuse(deep, checks), Refusal::below_base);
  // Level ground drives nothing.
  CutSurface level = cut_surface(slope, make_polyline({{2, 0}, {5, -2}, {10, -2}, {13, 0}}), 30, Checks{});
  for (const Method method : all_methods)
    EXPECT_EQ(solve(slope, level, method, Checks{}, false).refusal, Refusal::no_driving);
}

TEST(LemRefusals, TensionAndThrust) {
  // A steep weak slope: N' < 0 under a tenth of the base, and E outside the mass near the crest (Pruška 2003).
  const Slope slope(make_section({{0, 8}, {15, 8}, {25, 22}, {40, 22}}, make_soil(5, 10, 18), 0));
  CutSurface cut = cut_surface(slope, make_arc({8.126507, 27.89539}, 21.049263, 15, 28.333334), 100, report_only());
  Checks checks;
  const Solution accepted = solve(slope, cut, Method::spencer, checks, false);
  EXPECT_EQ(accepted.refusal, Refusal::none);
  checks.most_tension = 0.5 * accepted.tensile_share;
  EXPECT_EQ(solve(slope, cut, Method::spencer, checks, false).refusal, Refusal::tension);
  checks = {};
  checks.most_thrust_outside = 0.5 * accepted.thrust_outside;
  EXPECT_EQ(solve(slope, cut, Method::spencer, checks, false).refusal, Refusal::thrust);
  EXPECT_EQ(solve(slope, cut, Method::bishop, checks, false).refusal, Refusal::none);  // has no line of thrust
}

TEST(LemRefusals, CrackDeeperThanTheMass) {
  Section section = make_section({{0, 0}, {20, 0}, {30, 10}, {60, 10}}, make_soil(10, 30, 20), -5);
  section.crack = TensionCrack{30, 0};
  const Slope slope(std::move(section));
  EXPECT_EQ(cut_surface(slope, make_circle(slope, {22, 20}, 21), 30, report_only()).refusal, Refusal::too_shallow);
}

/// A surface along the boundary of two layers is in the upper one, whichever way its coordinates are rounded.
TEST(LemLayers, AlongABoundaryTheUpperOneCounts) {
  Section section = make_section({{0, 10}, {20, 10}, {50, 30}, {90, 30}}, make_soil(20, 15, 19), -5);
  section.soils.push_back(make_soil(300, 40, 22));
  section.regions.push_back(make_region_below(section, 1, {{0, 0}, {90, 30}}));
  const Slope slope(std::move(section));
  const auto along = [](double x) { return x / 3; };
  for (const double rounding : {-1e-9, 0.0, 1e-9}) {
    const Surface surface =
        make_polyline({{18, 10}, {22, along(22) + rounding}, {41.7, along(41.7) - rounding}, {60, 30}});
    const CutSurface cut = cut_surface(slope, surface, 60, report_only());
    ASSERT_EQ(cut.refusal, Refusal::none);
    for (const Slice& slice : cut.slices) EXPECT_EQ(slice.soil, 0);
  }
}

TEST(LemWarnings, NegativeEffectiveStressEverywhere) {
  Section section = make_section({{0, 0}, {20, 0}, {30, 10}, {60, 10}}, make_soil(10, 30, 20), -5);
  section.pressure_grid =
      PressureGrid{{{0, -9}, {60, -9}, {60, 20}, {0, 20}}, {{0, 1, 2}, {0, 2, 3}}, {400, 400, 300, 300}};
  const Slope slope(std::move(section));
  CutSurface cut = cut_surface(slope, make_circle(slope, {22, 20}, 21), 40, Checks{});
  ASSERT_EQ(cut.refusal, Refusal::none);
  ASSERT_FALSE(cut.warnings.empty());
  EXPECT_NE(cut.warnings[0].find("pore pressure exceeds the weight"), std::string::npos);
  for (const Method method : all_methods) EXPECT_NE(solve(slope, cut, method, Checks{}, false).refusal, Refusal::none);
}

// The factor jumps where a circle touches a strong layer: the forces along the base see the layer as soon as the arc
// does, however short the part.
TEST(LemStrongLayer, IsDetectedByTheShortestPartOfTheArc) {
  Section section = make_section({{0, 5}, {20, 5}, {30, 15}, {60, 15}}, make_soil(10, 20, 19), -5);
  section.soils.push_back(make_soil(5000, 40, 22));
  section.regions.push_back(make_region_below(section, 1, {{0, 3}, {60, 3}}));
  const Slope slope(std::move(section));
  const auto find_strong = [&](double deepest) {
    double length = 0;
    const Surface circle = make_circle(slope, {22, 25}, 25 - deepest);
    for (const Slice& slice : cut_surface(slope, circle, 20, report_only()).slices)
      if (slice.soil == 1) length += slice.length;
    return length;
  };
  EXPECT_EQ(find_strong(3.001), 0);
  // 2 √(2 R d) long for a depth d in the layer.
  EXPECT_NEAR(find_strong(2.999), 2 * std::sqrt(2 * 22 * 0.001), 1e-3);
}

}  // namespace
}  // namespace talus::lem
