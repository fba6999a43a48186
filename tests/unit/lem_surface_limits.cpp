// SPDX-License-Identifier: MIT
// Lines against polygons and windows, paths along layers, and the family of polylines of a search for blocks.

#include "lem/surface/limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lem/search/block_search.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

const std::vector<Point> square{{2, 2}, {6, 2}, {6, 6}, {2, 6}};

TEST(LemSurfaceLimits, ALineEntersAPolygonOnlyThroughItsInterior) {
  EXPECT_TRUE(enters_polygon(square, {0, 4}, {8, 4}));
  EXPECT_TRUE(enters_polygon(square, {3, 3}, {4, 5}));   // wholly inside
  EXPECT_TRUE(enters_polygon(square, {1, 1}, {7, 7}));   // through two corners
  EXPECT_TRUE(enters_polygon(square, {4, 4}, {9, 9}));   // from the inside
  EXPECT_FALSE(enters_polygon(square, {0, 2}, {8, 2}));  // along a side
  EXPECT_FALSE(enters_polygon(square, {0, 4}, {4, 0}));  // through a corner only
  EXPECT_FALSE(enters_polygon(square, {0, 7}, {8, 6.5}));
  const std::vector<Point> horseshoe{{0, 0}, {9, 0}, {9, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 6}, {0, 6}};
  EXPECT_FALSE(enters_polygon(horseshoe, {3.5, 8}, {5.5, 3.5}));  // into its opening
  EXPECT_TRUE(enters_polygon(horseshoe, {4, 4}, {5, 2}));
}

TEST(LemSurfaceLimits, ALineMeetsAWindow) {
  const Window line{"", {{3, 0}, {3, 5}, {4, 6}}, false}, box{"", {{2, 2}, {6, 6}}, true};
  EXPECT_TRUE(meets_window(line, {2, 1}, {4, 1}));
  EXPECT_TRUE(meets_window(line, {3, 5}, {9, 5}));  // an end on it
  EXPECT_FALSE(meets_window(line, {3.1, 0}, {9, 0}));
  EXPECT_TRUE(meets_window(box, {0, 3}, {9, 4}));
  EXPECT_TRUE(meets_window(box, {3, 3}, {4, 4}));
  EXPECT_FALSE(meets_window(box, {0, 4.5}, {1.9, 4.5}));
  EXPECT_FALSE(meets_window(box, {0, 3}, {3, 0}));  // its box overlaps, the line does not
}

TEST(LemSurfaceLimits, APathFollowsALayerOfSeveralRegions) {
  const Path path = make_path({{{0, 0}, {4, 1}, {4, 2}, {0, 1}}, {{4, 1}, {9, 1}, {9, 3}, {4, 2}}});
  ASSERT_EQ(path.bottom.size(), 3u);
  EXPECT_EQ(path.bottom, (std::vector<Point>{{0, 0}, {4, 1}, {9, 1}}));
  EXPECT_EQ(path.top, (std::vector<Point>{{0, 1}, {4, 2}, {9, 3}}));
  EXPECT_TRUE(make_path({{{0, 0}, {4, 1}, {4, 2}, {0, 1}}, {{5, 1}, {9, 1}, {9, 3}}}).bottom.empty());
}

/// Corners that bend to either side stay; thin_points() would drop the concave one first.
TEST(LemSurfaceLimits, PointsOnStraightLinesAreDropped) {
  const std::vector<Point> corners{{0, 10}, {4, 6}, {10, 7}, {14, 6.5}, {20, 12}};
  std::vector<Point> line{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 1; k <= 7; ++k) {
      const double t = k / 7.0;
      line.push_back({corners[i - 1][0] + t * (corners[i][0] - corners[i - 1][0]),
                      corners[i - 1][1] + t * (corners[i][1] - corners[i - 1][1])});
    }
  const std::vector<Point> kept = drop_straight_points(line);
  ASSERT_EQ(kept.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_NEAR(kept[i][1], corners[i][1], 1e-12);
  EXPECT_EQ(drop_straight_points({{0, 0}, {1, 1}}).size(), 2u);
}

/// A block under a slope of 1:2: its ends rise at the inclinations that were asked for, and meet the ground.
TEST(LemBlockFamily, EndsRiseAtTheirInclinations) {
  const Slope slope(make_section({{0, 10}, {30, 10}, {50, 20}, {90, 20}}, make_soil(5, 25, 19), 0));
  BlockSearch search;
  search.windows = {{"A", {{28, 8}}, false}, {"B", {{44, 9}, {52, 9}}, false}};
  search.active = {50 * degree, 70 * degree};
  search.passive = {20 * degree, 40 * degree};
  const BlockFamily family(slope, search, 0);
  ASSERT_EQ(family.size(), 3u);
  const auto surface = family.make({0.5, 0.25, 1}, true);
  ASSERT_TRUE(surface);
  ASSERT_EQ(surface->line.size(), 4u);
  const auto& line = surface->line;
  EXPECT_NEAR(std::atan2(line[0][1] - line[1][1], line[1][0] - line[0][0]), 30 * degree, 1e-12);
  EXPECT_NEAR(std::atan2(line[3][1] - line[2][1], line[3][0] - line[2][0]), 70 * degree, 1e-12);
  EXPECT_NEAR(line[2][0], 46, 1e-12);
  for (const Point& end : {line.front(), line.back()}) EXPECT_NEAR(end[1], slope.ground(end[0]), 1e-12);
  EXPECT_FALSE(family.make({0.5, 0.25, 1}, false)) << "the ground does not fall to the right";
  search.exit = std::array{28.0, 40.0};
  EXPECT_FALSE(BlockFamily(slope, search, 0).make({0.5, 0.25, 1}, true)) << "its exit lies left of the range";
}

TEST(LemBlockFamily, FollowsALayerFromItsBottomToItsTop) {
  const Slope slope(make_section({{0, 10}, {30, 10}, {50, 20}, {90, 20}}, make_soil(5, 25, 19), 0));
  BlockSearch search;
  search.path = make_path({{{0, 4}, {40, 6}, {90, 5}, {90, 6}, {40, 7}, {0, 5}}});
  search.active = search.passive = {45 * degree, 45 * degree};
  const BlockFamily family(slope, search, 0);
  for (const double level : {0.0, 0.5, 1.0}) {
    const auto surface = family.make({0.5, 0.3, 0.6, level, 0.5}, true);
    ASSERT_TRUE(surface);
    ASSERT_EQ(surface->line.size(), 5u);
    EXPECT_NEAR(surface->line[1][0], 27, 1e-9);
    EXPECT_NEAR(surface->line[2][0], 40, 1e-9);
    EXPECT_NEAR(surface->line[2][1], 6 + level, 1e-4);
    EXPECT_NEAR(surface->line[3][0], 54, 1e-9);
  }
}

TEST(LemBlockFamily, SpreadsAboutAsManySurfacesAsAsked) {
  const Slope slope(make_section({{0, 10}, {30, 10}, {50, 20}, {90, 20}}, make_soil(5, 25, 19), 0));
  BlockSearch search;
  search.active = {50 * degree, 70 * degree};
  search.passive = {30 * degree, 30 * degree};
  search.surfaces = 4000;
  for (int i = 0; i < 8; ++i) search.windows.push_back({"", {{20.0 + 4 * i, 3}, {22.0 + 4 * i, 5}}, true});
  const auto many = BlockFamily(slope, search, 0).spread(0);  // 16 places: a sequence instead of a lattice
  EXPECT_EQ(many.size(), 4000u);
  search.windows.resize(2);
  const auto few = BlockFamily(slope, search, 0).spread(0);
  EXPECT_LE(few.size(), 4000u);
  EXPECT_GE(few.size(), 2000u);
  for (const auto& p : few)
    for (const double t : p) EXPECT_TRUE(t >= 0 && t <= 1);
}

}  // namespace
}  // namespace talus::lem
