// SPDX-License-Identifier: MIT
// Overlaps and gaps of polygons against hand calculations, and random polygons against areas on a raster.
#include "mesh/cover.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/draw.hpp"

namespace talus::mesh {
namespace {

Plan make_plan(std::vector<Polygon> polygons) {
  Plan plan;
  plan.box_max = {40, 20};
  plan.polygons = std::move(polygons);
  return plan;
}

TEST(Cover, PolygonsWithCommonEdgesFit) {
  EXPECT_TRUE(find_misfits(make_plan({{"a", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}},
                                      {"b", {{0, 5}, {40, 5}, {20, 12}, {0, 12}}},
                                      {"lens", {{10, 2}, {30, 2}, {30, 4}, {10, 4}}},
                                      {"corner", {{0, 0}, {5, 0}, {5, 1}, {0, 1}}}}))
                  .empty())
      << "a lens, and one that shares two edges, lie wholly inside";
  // Corners on the inclined edge of the other, which no coordinate hits exactly.
  EXPECT_TRUE(find_misfits(make_plan({{"a", {{0, 0}, {40, 0}, {40, 7}}},
                                      {"b", {{0, 0}, {40, 7}, {40, 20}, {0, 20}}},
                                      {"c", {{10, 1.75}, {10, 1}, {20, 1}, {20, 3.5}}}}))
                  .empty());
}

TEST(Cover, AnOverlapHasItsAreaAndPlace) {
  // The triangle (0, 4.98), (20, 5), (0, 5) of the layer above lies in the one below: 20 · 0.02/2 = 0.2 m².
  const auto found = find_misfits(make_plan(
      {{"a", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}}, {"b", {{0, 4.98}, {20, 5.0}, {30, 5.0}, {18, 12}, {0, 12}}}}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Misfit::Kind::overlap);
  EXPECT_EQ(found[0].polygons, (std::vector<int>{0, 1}));
  EXPECT_NEAR(found[0].area, 0.2, 1e-6);
  EXPECT_EQ(found[0].pieces, 1);
  EXPECT_NEAR(found[0].largest.low[1], 4.98, 1e-7);
  EXPECT_NEAR(found[0].largest.high[0], 20, 1e-7);
  EXPECT_NEAR(found[0].largest.place[0], 10, 1e-7);
  EXPECT_NEAR(found[0].largest.place[1], 4.995, 1e-7);
}

TEST(Cover, ACrossIsOneOverlapAndACombHasSeveralPieces) {
  const auto cross = find_misfits(
      make_plan({{"a", {{0, 0}, {30, 0}, {30, 10}, {0, 10}}}, {"b", {{10, -1}, {20, -1}, {20, 11}, {10, 11}}}}));
  ASSERT_EQ(cross.size(), 1u);
  EXPECT_NEAR(cross[0].area, 100, 1e-5);
  const auto comb =
      find_misfits(make_plan({{"a", {{0, 0}, {40, 0}, {40, 10}, {0, 10}}},
                              {"b", {{0, 9}, {2, 9}, {2, 15}, {6, 15}, {6, 8}, {10, 8}, {10, 20}, {0, 20}}}}));
  ASSERT_EQ(comb.size(), 2u) << "and the air between the teeth is a gap";
  EXPECT_EQ(comb[0].pieces, 2);
  EXPECT_NEAR(comb[0].area, 2 * 1 + 4 * 2, 1e-5);
  EXPECT_NEAR(comb[0].largest.area, 8, 1e-5);
  EXPECT_EQ(comb[1].kind, Misfit::Kind::gap);
  EXPECT_NEAR(comb[1].area, 4 * 5, 1e-5);
}

TEST(Cover, TheSamePolygonTwiceIsReported) {
  const auto found =
      find_misfits(make_plan({{"a", {{0, 0}, {30, 0}, {30, 10}}}, {"b", {{30, 10}, {30, 0}, {15, 0}, {0, 0}}}}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Misfit::Kind::same);
  EXPECT_NEAR(found[0].area, 150, 1e-5);
}

TEST(Cover, AGapHasSoilAboveAndBelow) {
  // A layer that floats 2 cm above the other over 18 m, open to the air at its toe.
  const auto floating = find_misfits(
      make_plan({{"a", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}}, {"b", {{0, 5.02}, {18, 5.02}, {10, 12}, {0, 12}}}}));
  ASSERT_EQ(floating.size(), 1u);
  EXPECT_EQ(floating[0].kind, Misfit::Kind::gap);
  EXPECT_NEAR(floating[0].area, 18 * 0.02, 1e-6);
  EXPECT_EQ(floating[0].polygons, (std::vector<int>{1, 0}));
  // A base that is not level and a toe without soil are none.
  EXPECT_TRUE(find_misfits(make_plan({{"a", {{0, 4}, {20, 0}, {40, 3}, {40, 5}, {0, 15}}}})).empty());
}

TEST(Cover, WhatIsNarrowerThanTheToleranceIsNothing) {
  const auto layers = [](double gap) {
    return make_plan(
        {{"a", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}}, {"b", {{0, 5 + gap}, {40, 5 + gap}, {40, 9}, {0, 9}}}});
  };
  EXPECT_DOUBLE_EQ(get_section_tolerance(layers(0)), 4e-5);
  for (const double gap : {2e-6, -2e-6}) EXPECT_TRUE(find_misfits(layers(gap)).empty()) << gap;
  for (const double gap : {5e-5, -5e-5}) EXPECT_EQ(find_misfits(layers(gap)).size(), 1u) << gap;
}

TEST(Cover, CornersWithinTheToleranceAreJoined) {
  Plan plan = make_plan({{"a", {{0, 0}, {40, 0}, {40, 5}, {0, 5}}},
                         {"b", {{1e-5, 5.00002}, {20, 5.00003}, {39.99999, 5}, {18, 12}, {0, 12}}}});
  const std::vector<Joined> joined = join_corners(plan);
  EXPECT_EQ(joined.size(), 3u);
  EXPECT_EQ(plan.polygons[1].points[0], (Point2{0, 5}));
  EXPECT_EQ(plan.polygons[1].points[1], (Point2{20, 5})) << "onto the edge";
  EXPECT_EQ(plan.polygons[1].points[2], (Point2{40, 5}));
  EXPECT_TRUE(find_misfits(plan).empty());
  EXPECT_TRUE(join_corners(plan).empty());
  plan.polygons[1].points[1] = {20, 5.00005};
  EXPECT_TRUE(join_corners(plan).empty()) << "5e-5 m is more than a millionth of 40 m";
  // Rounding errors of other units stay as they are.
  plan.polygons[1].points[0] = {1e-12, 5 - 1e-12};
  EXPECT_TRUE(join_corners(plan).empty());
}

/// Common area of two stars about a centre, counted on a raster.
TEST(Cover, RandomStarsOverlapAsARasterCounts) {
  support::Draw draw(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polygon> stars;
    for (const char* name : {"a", "b"}) {
      Polygon star{name, {}};
      const double x = draw(12, 20), y = draw(8, 12);
      for (int i = 0; i < 9; ++i) {
        const double turn = 2 * 3.14159265358979 * i / 9, far = draw(2, 8);
        star.points.push_back({x + far * std::cos(turn), y + far * std::sin(turn)});
      }
      stars.push_back(star);
    }
    const Plan plan = make_plan(stars);
    double counted = 0;
    constexpr double step = 0.05;
    for (double x = step / 2; x < 30; x += step)
      for (double y = step / 2; y < 20; y += step)
        if (is_inside({x, y}, stars[0].points) && is_inside({x, y}, stars[1].points)) counted += step * step;
    double found = 0;
    for (const Misfit& misfit : find_misfits(plan))
      if (misfit.kind != Misfit::Kind::gap) {
        found += misfit.area;
        EXPECT_TRUE(is_inside(misfit.largest.place, stars[0].points) &&
                    is_inside(misfit.largest.place, stars[1].points));
      }
    EXPECT_NEAR(found, counted, 0.01 * counted + 0.05) << round;
  }
}

}  // namespace
}  // namespace talus::mesh
