// SPDX-License-Identifier: MIT
// Checks of the polygons, names, sizes and lines of a mesh, and removal of collinear points.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "mesh/quality.hpp"
#include "slope_plan.hpp"

namespace talus::mesh {
namespace {

std::string get_message(const Plan& plan) {
  try {
    generate<2>(plan);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    return error.what();
  }
  return "no error";
}

bool mentions(const std::string& message, const std::vector<std::string>& words) {
  for (const auto& word : words)
    if (message.find(word) == std::string::npos) {
      ADD_FAILURE() << "'" << word << "' is missing in: " << message;
      return false;
    }
  return true;
}

TEST(Plan, ReportsFaultsOfAPolygon) {
  Plan plan = plan_slope(1);
  plan.polygons[0].points = {{0, 0}, {10, 10}, {10, 0}, {0, 8}};
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "crosses", "(4.44444, 4.44444)"}));
  plan.polygons[0].points = {{0, 0}, {10, 0}, {10, 5}, {5, 0}, {0, 5}};  // a corner touches an edge
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "touches", "(5, 0)"}));
  plan.polygons[0].points = {{0, 0}, {10, 0}, {5, 0}};  // no area
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'"}));
  plan.polygons[0].points = {{0, 0}, {44.5, 0}, {10, 10}};
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "leaves the box", "(44.5, 0)"}));
  plan.polygons[0].points = {{0, 0}, {10, 0}, {10, 10}, {0, 0}};
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "(0, 0)", "twice"}));
  plan.polygons[0].points = {{0, 0}, {10, 0}};
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "2 points", "3"}));
}

/// Points on one straight edge, rounded: two such edges are nearly parallel and seem to cross anywhere.
TEST(Plan, TakesAnyPointsAlongAStraightEdge) {
  unsigned random = 1;
  for (int i = 0; i < 200; ++i) {
    Polyline corners{{0, 0}, {44, 0}, {44, 5}};
    double along = 0;
    while (true) {
      random = random * 1664525u + 1013904223u;
      along += 0.05 + 0.3 * (random / 4294967296.0);
      if (along > 0.98) break;
      corners.push_back({32 - along * 20, 5 + along * 10});
    }
    corners.push_back({12, 15});
    corners.push_back({0, 15});
    EXPECT_EQ(find_self_contact(corners, 1e-9), std::nullopt) << i;
  }
  EXPECT_TRUE(find_self_contact({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 1e-9).has_value()) << "a bow tie";
}

TEST(Plan, ReportsOverlappingPolygons) {
  Plan plan = plan_slope(1);
  plan.polygons = {{"a", {{2, 2}, {10, 2}, {10, 8}, {2, 8}}}, {"b", {{6, 4}, {14, 4}, {14, 6}, {6, 6}}}};
  EXPECT_TRUE(mentions(get_message(plan), {"'a'", "'b'", "overlap"}));
  plan.polygons[1].points = {{2, 2}, {10, 8}, {10, 12}, {2, 12}};  // through two corners, crossing no edge inside it
  EXPECT_TRUE(mentions(get_message(plan), {"'a'", "'b'", "overlap"}));
  plan.polygons[1].points = {{10, 8}, {2, 8}, {2, 2}, {10, 2}};
  EXPECT_TRUE(mentions(get_message(plan), {"'a'", "'b'", "same"}));
}

TEST(Plan, ClassifiesTheRelationOfTwoPolygons) {
  const Polyline square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(compare(square, {{4, 1}, {6, 1}, {6, 9}, {4, 9}}, 1e-6), Relation::apart);   // common part of an edge
  EXPECT_EQ(compare(square, {{4, 4}, {6, 4}, {6, 6}}, 1e-6), Relation::apart);           // common corner
  EXPECT_EQ(compare(square, {{0, 0}, {2, 0}, {2, 4}, {0, 4}}, 1e-6), Relation::around);  // three common edges
  EXPECT_EQ(compare({{1, 1}, {2, 1}, {2, 2}}, square, 1e-6), Relation::inside);
  EXPECT_EQ(compare(square, {{-1, 1}, {5, 1}, {5, 2}, {-1, 2}}, 1e-6), Relation::overlapping);  // a cross
}

TEST(Plan, ReportsFaultsOfNamesSizesAndLines) {
  Plan plan = plan_slope(1);
  plan.lines = {{"top", {{0, 1}, {2, 1}}}};
  EXPECT_TRUE(mentions(get_message(plan), {"'top'", "taken"}));
  plan.lines = {{"drain", {{40, 1}, {50, 1}}}};
  EXPECT_TRUE(mentions(get_message(plan), {"'drain'", "leaves the box", "(50, 1)"}));
  plan.lines.clear();
  plan.polygons.push_back(plan.polygons[0]);
  EXPECT_TRUE(mentions(get_message(plan), {"'soil'", "own name"}));
  plan.polygons.pop_back();
  plan.size = 0;
  EXPECT_TRUE(mentions(get_message(plan), {"size", "positive"}));
  plan.size = 1;
  plan.box_max = {-4, 17};
  EXPECT_TRUE(mentions(get_message(plan), {"box", "(-4, 17)"}));
}

TEST(Plan, TakesPointsThatMissEachOtherByRoundingAsOne) {
  Plan plan = plan_slope(1);
  plan.polygons[0].points[4] = {12 + 3e-9, 15 - 2e-9};
  plan.polygons[0].points[1] = {44 + 1e-10, -1e-10};
  plan.lines = {{"crest", {{0, 15}, {12, 15}}}, {"slope", {{12, 15}, {32 + 1e-9, 5}}}};
  const auto mesh = generate<2>(plan);
  EXPECT_NEAR(sum_region(mesh, 0), 440, 1e-5);
  EXPECT_NEAR(measure_length(mesh, "crest"), 12, 1e-7);
  EXPECT_GT(measure_quality(mesh, false).min_altitude, 0.5);
}

TEST(Planar, StraightPointsAreDroppedAndCornersStay) {
  const Polyline square{{0.5, 0}, {1, 0}, {1, 0.25}, {1, 1}, {0, 1}, {0, 0}, {0.25, 0}};
  EXPECT_EQ(drop_straight_points(square, true, 1e-9), (Polyline{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(drop_straight_points({{0, 0}, {1, 1e-10}, {2, 0}, {2, 3}, {2, 1}}, false, 1e-9),
            (Polyline{{0, 0}, {2, 0}, {2, 3}, {2, 1}}));  // a line that turns back keeps its end
}

TEST(Planar, PointsBesideAKinkDoNotMoveIt) {
  const Polyline line{{0, 0}, {10, 3e-9}, {20, 0}};
  const auto interpolate = [&](std::size_t i, double t) {
    return Point2{line[i][0] + t * 10, line[i][1] + t * (line[i + 1][1] - line[i][1])};
  };
  const Polyline refined{line[0], interpolate(0, 0.2), interpolate(0, 0.9), line[1], interpolate(1, 0.1), line[2]};
  EXPECT_EQ(drop_straight_points(line, false, 1e-9), line);
  EXPECT_EQ(drop_straight_points(refined, false, 1e-9), line);
}

/// Each point of a flat arc lies within the tolerance of its neighbours' chord, and not of the chord of all.
TEST(Planar, ADenselyDrawnArcKeepsItsRise) {
  Polyline arc;
  for (int i = 0; i <= 1000; ++i) arc.push_back({0.001 * i, 1e-3 * i * (1000 - i) * 4e-6});
  const Polyline kept = drop_straight_points(arc, false, 2e-7);
  EXPECT_LT(kept.size(), arc.size() / 2);
  for (const Point2& x : arc) EXPECT_LT(compute_distance(x, kept), 2.1e-7);
}

}  // namespace
}  // namespace talus::mesh
