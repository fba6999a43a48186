// SPDX-License-Identifier: MIT
// Depth of a tension crack against Rankine's closed forms, and factors of masses that end in one.

#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

const std::vector<Point> cut{{0, 12}, {18, 12}, {24, 6}, {40, 6}};

/// Depth of a crack of 6 m, with water up to `water` in it, at the crest of `section`.
double find_depth(Section section, double water = 0) {
  section.crack = TensionCrack{6, water, true};
  return Slope(section).crack_depth(10);
}

double find_root(double friction_degrees) {
  return std::tan((45 - friction_degrees / 2) * degree);  // of K_a
}

TEST(TensionCrack, EndsWhereRankinesStressIsZero) {
  EXPECT_NEAR(find_depth(make_section(cut, make_soil(30, 0, 18), 0)), 2 * 30.0 / 18, 1e-6) << "2c/γ";
  EXPECT_NEAR(find_depth(make_section(cut, make_soil(10, 25, 19), 0)), 2 * 10.0 / (19 * find_root(25)), 1e-6)
      << "2c/γ·tan(45° + φ/2)";
  EXPECT_NEAR(find_depth(make_section(cut, make_soil(0, 30, 19), 0)), 0, 1e-6) << "sand has no tension";
  EXPECT_EQ(find_depth(make_section(cut, make_soil(80, 0, 18), 0)), 6) << "as given where tension reaches deeper";
}

TEST(TensionCrack, EndsWhereItsWaterNoLongerHoldsItOpen) {
  const double root = find_root(10), ka = root * root;
  EXPECT_NEAR(find_depth(make_section(cut, make_soil(10, 10, 20), 0), 6), 2 * 10 * root / (ka * 20 - 9.81), 1e-6);
  EXPECT_NEAR(find_depth(make_section(cut, make_soil(10, 10, 20), 0), 1), (2 * 10 * root + 9.81) / (ka * 20), 1e-6)
      << "a metre of water";
  EXPECT_EQ(find_depth(make_section(cut, make_soil(10, 40, 20), 0), 6), 6) << "K_a γ < γ_w: water opens it further";
}

TEST(TensionCrack, IsClosedByPorePressureAndLoad) {
  const double root = find_root(25), ka = root * root;
  Section wet = make_section(cut, make_soil(10, 25, 20), 0);
  wet.water_table = {{0, 12}, {18, 12}, {24, 6}, {40, 6}};
  EXPECT_NEAR(find_depth(wet), 2 * 10 * root / (ka * (20 - 9.81) + 9.81), 1e-6) << "u closes a dry crack";
  Section loaded = make_section(cut, make_soil(10, 25, 20), 0);
  loaded.surcharges = {{{{5, 15}, {15, 15}}}};
  EXPECT_NEAR(find_depth(loaded), (2 * 10 / root - 15) / 20, 1e-6);
  loaded.surcharges = {{{{5, 60}, {15, 60}}}};
  EXPECT_NEAR(find_depth(loaded), 0, 1e-6);
}

TEST(TensionCrack, FollowsTheLayers) {
  Section section = make_section(cut, make_soil(5, 0, 18), 0);
  section.soils.push_back(make_soil(40, 0, 18));
  section.regions.push_back(make_region_below(section, 1, {{0, 11.8}, {40, 11.8}}));
  EXPECT_NEAR(find_depth(section), 2 * 40.0 / 18, 1e-6) << "stiff clay under 0.2 m that are in tension themselves";
  section.regions.back() = make_region_below(section, 1, {{0, 11}, {40, 11}});
  EXPECT_NEAR(find_depth(section), 2 * 5.0 / 18, 1e-6) << "under a metre that is not";
}

/// 0 where the crack leaves nothing of the mass.
double find_bishop(const Slope& slope, const Surface& circle) {
  CutSurface mass = cut_surface(slope, circle, 100, report_only());
  return mass.refusal == Refusal::none ? solve(slope, mass, Method::bishop, report_only(), false).factor : 0;
}

/// A deeper crack only takes strength away from the mass, as long as the soil beside it is in tension.
TEST(TensionCrack, DeeperThanTensionChangesNothing) {
  const auto find_least = [](double depth, bool limited) {
    Section section = make_section(cut, make_soil(30, 0, 18), 0);
    if (depth > 0) section.crack = TensionCrack{depth, 0, limited};
    const Slope slope(section);
    double least = 1e9;
    for (const double y : {14.0, 16.0, 18.0, 20.0})
      for (int i = 0; i < 10; ++i)
        if (const double f = find_bishop(slope, make_circle(slope, {22, y}, y - 5.5 + 0.5 * i)); f > 0)
          least = std::min(least, f);
    return least;
  };
  double before = find_least(0, true);
  for (const double depth : {1.0, 2.0, 3.0}) {
    const double factor = find_least(depth, true);
    EXPECT_LT(factor, before) << depth;
    EXPECT_NEAR(factor, find_least(depth, false), 1e-9) << depth;
    before = factor;
  }
  const double limit = find_least(2 * 30.0 / 18, true);
  for (const double depth : {4.0, 5.0, 6.0, 20.0}) EXPECT_NEAR(find_least(depth, true), limit, 1e-6) << depth;
  EXPECT_GT(find_least(6, false), 1.1 * limit) << "as deep as the slope is high, as given";
}

/// A limit takes thrust of the water as well as length from a crack: neither depth may make a surface safer than the
/// other. On a plane all methods have one factor.
TEST(TensionCrack, WithWaterHasTheDepthOfTheSmallerFactor) {
  const double limit = 2 * 12.0 / (19 * find_root(20));
  const auto find_plane = [](double crack, double water, bool limited, double top) {
    Section section = make_section({{-5, 0}, {0, 0}, {4, 12}, {60, 12}}, make_soil(12, 20, 19), -5);
    section.crack = TensionCrack{crack, water, limited};
    return find_factor(Slope(std::move(section)), make_polyline({{0, 0}, {top, 12}}), Method::spencer, 60);
  };
  bool given_governs = false, limit_governs = false;
  for (const auto& [depth, top] : {std::pair{5.0, 12.0}, {5.0, 20.0}, {7.5, 12.0}})
    for (const double water : {0.2, 1.0, 2.5, 4.0, 5.0}) {
      Section wet = make_section({{-5, 0}, {0, 0}, {4, 12}, {60, 12}}, make_soil(12, 20, 19), -5);
      wet.crack = TensionCrack{depth, water, true};
      const double unlimited = Slope(std::move(wet)).crack_depth(10);
      EXPECT_GE(unlimited, limit - 1e-6);
      const double given = find_plane(depth, water, false, top),
                   limited = find_plane(unlimited, std::min(water, unlimited), false, top);
      given_governs = given_governs || given < limited - 1e-3;
      limit_governs = limit_governs || limited < given - 1e-3;
      EXPECT_NEAR(find_plane(depth, water, true, top), std::min(given, limited), 1e-6)
          << depth << " m, water " << water << " m, " << top;
    }
  EXPECT_TRUE(given_governs) << "or a part of the rule was not tried";
  EXPECT_TRUE(limit_governs) << "or a part of the rule was not tried";
}

}  // namespace
}  // namespace talus::lem
