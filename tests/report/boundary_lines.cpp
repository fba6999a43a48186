// SPDX-License-Identifier: MIT
// Sides of a mesh are joined to polylines.

#include "report/content/model.hpp"

#include <gtest/gtest.h>

namespace talus::report {
namespace {

/// Nodes only: sides need no elements.
mesh::Mesh<2> make_nodes(std::vector<std::array<double, 2>> nodes) {
  mesh::Mesh<2> mesh;
  mesh.nodes = std::move(nodes);
  return mesh;
}

TEST(BoundaryLines, SidesInAnyOrderAreJoinedAndStraightStretchesKeepTheirEnds) {
  const auto mesh = make_nodes({{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}});
  const auto lines = join_sides(mesh, {{3, 2}, {0, 1}, {4, 3}, {2, 1}});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], (Polyline{{0, 0}, {2, 0}, {4, 2}}));
}

TEST(BoundaryLines, PiecesStayApartAndARingIsClosed) {
  const auto mesh = make_nodes({{0, 0}, {1, 0}, {5, 0}, {6, 0}, {0, 5}, {1, 5}, {0, 6}});
  const auto lines = join_sides(mesh, {{0, 1}, {2, 3}, {4, 5}, {5, 6}, {6, 4}});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], (Polyline{{0, 0}, {1, 0}}));
  EXPECT_EQ(lines[1], (Polyline{{5, 0}, {6, 0}}));
  EXPECT_EQ(lines[2].size(), 4u);
  EXPECT_EQ(lines[2].front(), lines[2].back());
}

}  // namespace
}  // namespace talus::report
