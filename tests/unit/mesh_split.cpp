// SPDX-License-Identifier: MIT
// A cut mesh: nodes on either side of the cut, neighbours, named sides, and cuts that do not separate.

#include "mesh/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {
namespace {

/// A box of 4 m × 4 m, soil up to `level`, with a line from its top at x = 2 to y = `toe`.
Mesh<2> make_box(double level, double toe, double size = 0.5) {
  Plan plan;
  plan.box_max = {4, 4};
  plan.size = size;
  plan.polygons = {{"soil", {{0, 0}, {4, 0}, {4, level}, {0, level}}}};
  plan.lines = {{"wall", {{2, level}, {2, toe}}}, {"ground", {{0, level}, {4, level}}}};
  return generate<2>(plan);
}

Cuts list_edges(const Mesh<2>& mesh, double low, double high) {
  std::vector<std::pair<double, int>> found;
  for (int n = 0; n < mesh.node_count(); ++n)
    if (std::abs(mesh.nodes[n][0] - 2) < 1e-9 && mesh.nodes[n][1] > low - 1e-9 && mesh.nodes[n][1] < high + 1e-9)
      found.emplace_back(mesh.nodes[n][1], n);
  std::sort(found.begin(), found.end());
  Cuts cuts;
  for (std::size_t i = 1; i < found.size(); ++i) cuts.push_back({found[i - 1].second, found[i].second});
  return cuts;
}

double find_middle(const Mesh<2>& mesh, std::size_t e) {
  double x = 0;
  for (const int n : mesh.elements[e]) x += mesh.nodes[static_cast<std::size_t>(n)][0] / 3;
  return x;
}

TEST(MeshSplit, SeparatesTheElementsOfBothSides) {
  for (const double level : {4.0, 3.0}) {  // air above the soil does not join the sides at the head
    const Mesh<2> mesh = make_box(level, 1);
    const Cuts cuts = list_edges(mesh, 1, level);
    const Mesh<2> cut = split(mesh, cuts, "cut");
    EXPECT_EQ(cut.nodes.size(), mesh.nodes.size() + cuts.size()) << "each node but the toe has a double";
    ASSERT_EQ(cut.elements.size(), mesh.elements.size());
    for (std::size_t e = 0; e < cut.elements.size(); ++e) {
      EXPECT_EQ(cut.volumes[e], mesh.volumes[e]);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(cut.nodes[cut.elements[e][k]], mesh.nodes[mesh.elements[e][k]]);
        const int behind = cut.neighbours[e][k];
        if (behind < 0 || cut.element_region[e] == empty_region ||
            cut.element_region[static_cast<std::size_t>(behind)] == empty_region)
          continue;
        const auto &a = cut.nodes[cut.elements[e][(k + 1) % 3]], &b = cut.nodes[cut.elements[e][(k + 2) % 3]];
        const bool on_cut = std::abs(a[0] - 2) < 1e-9 && std::abs(b[0] - 2) < 1e-9 && std::min(a[1], b[1]) > 1 - 1e-9;
        EXPECT_FALSE(on_cut) << e;
      }
    }
    EXPECT_EQ(cut.sides.at("cut").size(), 2 * cuts.size()) << "both sides of each edge";
    // Sides of the ground have the nodes of the elements below them.
    EXPECT_EQ(cut.sides.at("ground").size(), mesh.sides.at("ground").size());
    for (const auto& side : cut.sides.at("ground")) {
      bool is_found = false;
      for (std::size_t e = 0; e < cut.elements.size(); ++e) {
        const auto& nodes = cut.elements[e];
        const bool has =
            std::count(nodes.begin(), nodes.end(), side[0]) && std::count(nodes.begin(), nodes.end(), side[1]);
        if (!has || cut.element_region[e] == empty_region) continue;
        is_found = true;
        EXPECT_EQ(find_middle(cut, e) < 2, 0.5 * (cut.nodes[side[0]][0] + cut.nodes[side[1]][0]) < 2);
      }
      EXPECT_TRUE(is_found);
    }
  }
}

TEST(MeshSplit, ToTheBottomLeavesTwoBodies) {
  const Mesh<2> mesh = make_box(4, 0), cut = split(mesh, list_edges(mesh, 0, 4), "cut");
  for (std::size_t e = 0; e < cut.elements.size(); ++e)
    for (const int behind : cut.neighbours[e])
      EXPECT_TRUE(behind < 0 || (find_middle(cut, e) < 2) == (find_middle(cut, static_cast<std::size_t>(behind)) < 2));
}

TEST(MeshSplit, RefusesASingleEdgeInsideTheSoil) {
  const Mesh<2> mesh = make_box(4, 1);
  const Cuts cuts = list_edges(mesh, 1, 4);
  EXPECT_THROW(split(mesh, {cuts[1]}, "cut"), Error);
}

}  // namespace
}  // namespace talus::mesh
