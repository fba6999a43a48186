// SPDX-License-Identifier: MIT
// The finished mesh: volumes, gradients and quality by hand, neighbours, renumbering, and rejected meshes.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "base/error.hpp"
#include "mesh/quality.hpp"
#include "mesh_grid.hpp"

namespace talus::mesh {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The nodes' places of every element, free of any numbering.
template <int D>
std::multiset<std::pair<std::multiset<std::array<double, D>>, int>> collect(const Mesh<D>& mesh) {
  std::multiset<std::pair<std::multiset<std::array<double, D>>, int>> elements;
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::multiset<std::array<double, D>> places;
    for (int node : mesh.elements[e]) places.insert(mesh.nodes[node]);
    elements.insert({places, mesh.element_region[e]});
  }
  return elements;
}

template <int D>
void shuffle(Mesh<D>& mesh) {
  std::mt19937 random(7);
  std::vector<int> place(mesh.nodes.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  auto nodes = mesh.nodes;
  for (std::size_t i = 0; i < place.size(); ++i) nodes[place[i]] = mesh.nodes[i];
  mesh.nodes = nodes;
  for (auto& element : mesh.elements)
    for (int& node : element) node = place[node];
  for (auto& [name, sides] : mesh.sides)
    for (auto& side : sides)
      for (int& node : side) node = place[node];
  std::shuffle(mesh.elements.begin(), mesh.elements.end(), random);
}

template <int D>
void expect_neighbours_share_their_side(const Mesh<D>& mesh, int border_sides) {
  int border = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const int other = mesh.neighbours[e][k];
      if (other < 0) {
        ++border;
        continue;
      }
      std::set<int> side(mesh.elements[e].begin(), mesh.elements[e].end());
      side.erase(mesh.elements[e][k]);
      int back = -1;
      for (int j = 0; j <= D; ++j)
        if (mesh.neighbours[other][j] == e) back = j;
      ASSERT_GE(back, 0);
      std::set<int> seen(mesh.elements[other].begin(), mesh.elements[other].end());
      seen.erase(mesh.elements[other][back]);
      ASSERT_EQ(side, seen);
    }
  EXPECT_EQ(border, border_sides);
}

TEST(Finish, GivesTheRightTriangleItsHandValues) {
  Mesh<2> mesh;
  mesh.nodes = {{0, 0}, {3, 0}, {0, 4}};
  mesh.elements = {{0, 2, 1}};  // clockwise: must be turned
  mesh.element_region = {0};
  finish(mesh);
  EXPECT_DOUBLE_EQ(mesh.volumes[0], 6);
  EXPECT_DOUBLE_EQ(mesh.altitudes[0], 2.4);  // 2A / hypotenuse = 12 / 5
  for (int k = 0; k < 2; ++k) {              // ξ is 1 at its own node and 0 at the others
    std::array<double, 2> xi = to_local(mesh, 0, mesh.nodes[mesh.elements[0][k + 1]]);
    EXPECT_NEAR(xi[k], 1, 1e-15);
    EXPECT_NEAR(xi[1 - k], 0, 1e-15);
  }
}

TEST(Finish, GivesTheCornerTetrahedronItsHandValues) {
  Mesh<3> mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.elements = {{1, 0, 2, 3}};
  mesh.element_region = {0};
  finish(mesh);
  EXPECT_DOUBLE_EQ(mesh.volumes[0], 1.0 / 6);
  EXPECT_NEAR(mesh.altitudes[0], 1 / std::sqrt(3.0), 1e-15);  // distance of the origin from x + y + z = 1
  const auto quality = measure_quality(mesh);
  EXPECT_NEAR(quality.min_angle, std::acos(1 / std::sqrt(3.0)), 1e-14);
  // r = 3V / surface = 1 / (3 + √3), R = √3 / 2
  EXPECT_NEAR(quality.min_radius_ratio, 3 * 2 / ((3 + std::sqrt(3.0)) * std::sqrt(3.0)), 1e-14);
}

TEST(Finish, CallsTheEquilateralTrianglePerfect) {
  Mesh<2> mesh;
  mesh.nodes = {{0, 0}, {2, 0}, {1, std::sqrt(3.0)}};
  mesh.elements = {{0, 1, 2}};
  mesh.element_region = {0};
  finish(mesh);
  const auto quality = measure_quality(mesh);
  EXPECT_NEAR(quality.min_angle, std::acos(0.5), 1e-14);
  EXPECT_NEAR(quality.min_radius_ratio, 1, 1e-14);
  EXPECT_NEAR(quality.min_altitude, std::sqrt(3.0), 1e-14);
}

TEST(Finish, KeepsEveryElementWithItsRegionAndSideThroughTheRenumbering) {
  Mesh<2> mesh = make_grid(9, 7, 0.5);
  shuffle(mesh);
  for (int e = 0; e < mesh.element_count(); ++e) {
    double x = 0;
    for (int node : mesh.elements[e]) x += mesh.nodes[node][0] / 3;
    mesh.element_region[e] = x > 2 ? 1 : 0;
  }
  for (const auto& element : mesh.elements)
    for (int k = 0; k < 3; ++k)
      if (const int a = element[k], b = element[(k + 1) % 3]; mesh.nodes[a][1] == 0 && mesh.nodes[b][1] == 0)
        mesh.sides["bottom"].push_back({a, b});
  const auto before = collect(mesh);
  finish(mesh);
  EXPECT_EQ(collect(mesh), before);
  EXPECT_NEAR(sum(mesh.volumes), 4.5 * 3.5, 1e-13);
  ASSERT_EQ(mesh.sides["bottom"].size(), 9u);
  double length = 0;
  for (const auto& [a, b] : mesh.sides["bottom"]) {
    EXPECT_EQ(mesh.nodes[a][1], 0);
    length += std::abs(mesh.nodes[a][0] - mesh.nodes[b][0]);
  }
  EXPECT_NEAR(length, 4.5, 1e-14);
  expect_neighbours_share_their_side(mesh, 2 * (9 + 7));
}

TEST(Finish, FindsEveryNeighbourAmongTetrahedra) {
  Mesh<3> mesh = make_grid(4, 3, 5, 0.25);
  shuffle(mesh);
  finish(mesh);
  EXPECT_NEAR(sum(mesh.volumes), 4 * 3 * 5 * std::pow(0.25, 3), 1e-14);
  for (double volume : mesh.volumes) EXPECT_GT(volume, 0);
  expect_neighbours_share_their_side(mesh, 2 * 2 * (4 * 3 + 4 * 5 + 3 * 5));
}

TEST(Finish, OrdersNearElementsNearEachOther) {
  Mesh<2> mesh = make_grid(64, 64, 1);
  shuffle(mesh);
  finish(mesh);
  // A random order has a mean step of 33 between elements that follow each other; along the Morton curve it is about 1.
  double way = 0;
  for (int e = 1; e < mesh.element_count(); ++e) {
    const auto a = get_centroid(mesh, e - 1), b = get_centroid(mesh, e);
    way += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  EXPECT_LT(way / mesh.element_count(), 1.5);
}

TEST(Finish, GivesTheSameMeshForEveryNumberingOfTheSameElements) {
  Mesh<2> a = make_grid(20, 11, 0.3), b = a;
  shuffle(b);
  finish(a);
  finish(b);
  for (int e = 0; e < a.element_count(); ++e) {
    const auto x = get_centroid(a, e), y = get_centroid(b, e);
    EXPECT_NEAR(x[0], y[0], 1e-14);
    EXPECT_NEAR(x[1], y[1], 1e-14);
  }
}

TEST(Finish, CanKeepTheNumbering) {
  Mesh<2> mesh = make_grid(3, 2, 1);
  shuffle(mesh);
  mesh.nodes.push_back({50, 50});  // of no element
  const auto elements = mesh.elements;
  const auto nodes = mesh.nodes;
  finish(mesh, Order::as_given);
  EXPECT_EQ(mesh.elements, elements);
  EXPECT_EQ(mesh.nodes, nodes);
}

TEST(Finish, DropsNodesOfNoElement) {
  Mesh<2> mesh = make_grid(3, 2, 1);
  mesh.nodes.insert(mesh.nodes.begin(), {9, 9});
  for (auto& element : mesh.elements)
    for (int& node : element) ++node;
  finish(mesh);
  EXPECT_EQ(mesh.node_count(), 12);
  EXPECT_NEAR(sum(mesh.volumes), 6, 1e-14);
}

std::string get_message(Mesh<2> mesh) {
  try {
    finish(mesh);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    return error.what();
  }
  return "";
}

TEST(Finish, RefusesWhatIsNoMesh) {
  Mesh<2> flat = make_grid(2, 2, 1);
  flat.elements[3] = {0, 1, 2};  // three nodes on one line
  EXPECT_NE(get_message(flat).find("element 4"), std::string::npos);
  Mesh<2> folded = make_grid(1, 1, 1);
  folded.elements.push_back({0, 1, 2});
  folded.element_region.push_back(0);
  EXPECT_EQ(get_message(folded), "");  // two elements on a side are possible, three are not
  folded.elements.push_back({0, 3, 1});
  folded.element_region.push_back(0);
  EXPECT_NE(get_message(folded).find("overlap"), std::string::npos);
  Mesh<2> wrong = make_grid(1, 1, 1);
  wrong.elements[0][0] = 4;
  EXPECT_NE(get_message(wrong).find("node 4"), std::string::npos);
  EXPECT_NE(get_message(Mesh<2>{}).find("no elements"), std::string::npos);
}

}  // namespace
}  // namespace talus::mesh
