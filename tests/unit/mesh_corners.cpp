// SPDX-License-Identifier: MIT
// Re-entrant corners of the ground and the element size at them.

#include "mesh/planar.hpp"

#include <gtest/gtest.h>

#include "mesh/gmsh_mesh.hpp"

namespace talus::mesh {
namespace {

Plan plan_soil(std::vector<Polyline> rings) {
  Plan plan;
  plan.box_max = {44, 17};
  plan.size = 1;
  for (std::size_t i = 0; i < rings.size(); ++i)
    plan.polygons.push_back({"soil" + std::to_string(i), std::move(rings[i])});
  return plan;
}

TEST(Corners, OfTheGroundThatPointIntoTheSoil) {
  using Points = std::vector<Point2>;
  const auto find = [](std::vector<Polyline> rings) { return find_reentrant_corners(plan_soil(std::move(rings))); };
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}), (Points{{32, 5}})) << "the toe alone";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 5}, {20, 5}, {20, 15}, {0, 15}}}), (Points{{20, 5}})) << "a vertical cut";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 5}, {32, 5}, {26, 9}, {20, 9}, {12, 15}, {0, 15}}}),
            (Points{{32, 5}, {20, 9}}))
      << "a bench has a toe of its own";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 8}, {0, 8}}, {{0, 8}, {40, 8}, {20, 16}, {0, 16}}}), (Points{{40, 8}}))
      << "the toe of a layer on another";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 8}, {0, 8}}, {{10, 3}, {14, 3}, {14, 5}, {10, 5}}}), Points{})
      << "a lens has soil all around";
  EXPECT_EQ(find({{{0, 0}, {32, 0}, {12, 10}, {0, 10}}}), Points{}) << "a toe on the floor is no corner of the soil";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 5.5}, {22, 5}, {0, 6}}}), Points{}) << "a bend of 4°";
  EXPECT_EQ(find({{{0, 0}, {44, 0}, {44, 15}, {0, 15}}}), Points{}) << "a corner of the box is a wall's";
}

TEST(Corners, HaveElementsOfTheirOwnSize) {
  const Plan plan = refine_corners(plan_soil({{{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}), 4, 8);
  EXPECT_DOUBLE_EQ(compute_size(plan, {32, 5}), 0.25);
  EXPECT_DOUBLE_EQ(compute_size(plan, {32, 1}), 0.625) << "on half of the way to the general size";
  EXPECT_DOUBLE_EQ(compute_size(plan, {24, 5}), 1);
  EXPECT_TRUE(
      refine_corners(plan_soil({{{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}), 1, 8).refinements.empty());
}

}  // namespace
}  // namespace talus::mesh
