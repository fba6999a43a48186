// SPDX-License-Identifier: MIT
// Location of points in a mesh, and columns of soil above a point.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/generate.hpp"
#include "mesh/locate.hpp"
#include "mesh/points.hpp"
#include "mesh_grid.hpp"

namespace talus::mesh {
namespace {

constexpr double unit_weight = 20e3;  ///< [N/m³]

Mesh<2> make_slope() {
  Plan plan;
  plan.box_max = {44, 17};
  plan.size = 1;
  plan.polygons = {{"soil", {{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}};
  return generate<2>(plan);
}

template <int D>
std::vector<double> weigh(const Mesh<D>& mesh, double value) {
  std::vector<double> weight(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) weight[e] = mesh.element_region[e] == empty_region ? 0 : value;
  return weight;
}

template <int D>
LocalPoint<D> place(const Mesh<D>& mesh, const typename Mesh<D>::Point& x) {
  const int e = find_element(mesh, x);
  EXPECT_GE(e, 0);
  return {e, to_local(mesh, e, x)};
}

TEST(Locate, FindsTheElementThatEveryRandomPointWasDrawnFrom) {
  Mesh<3> mesh = make_grid(6, 5, 4, 0.5);
  finish(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<int> any(0, mesh.element_count() - 1);
  for (int i = 0; i < 2000; ++i) {
    double u[4], total = 0;
    for (double& v : u) total += v = 0.01 + unit(random);
    const int e = any(random);
    const auto x = to_global(mesh, e, {u[1] / total, u[2] / total, u[3] / total});
    ASSERT_EQ(find_element(mesh, x, any(random)), e);
    const auto xi = to_local(mesh, e, x);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(xi[k], u[k + 1] / total, 1e-13);
  }
}

TEST(Locate, FindsPointsOfTheBorderAndNoneOutside) {
  const auto mesh = make_slope();
  for (const Mesh<2>::Point& x : {Mesh<2>::Point{0, 0}, {44, 17}, {44, 0}, {22, 0}, {12, 15}, {0, 8.3}})
    EXPECT_GE(find_element(mesh, x), 0) << x[0] << " " << x[1];
  EXPECT_EQ(find_element(mesh, {44.001, 5}), -1);
  EXPECT_EQ(find_element(mesh, {20, -1e-6}), -1);
}

TEST(Locate, SeesAroundTheNotchOfAMeshThatIsNotConvex) {
  Mesh<2> mesh = make_grid(9, 9, 1);  // an arch: the walk from one leg to the other meets the border
  std::vector<Mesh<2>::Element> kept;
  for (const auto& element : mesh.elements) {
    double x = 0, y = 0;
    for (int node : element) {
      x += mesh.nodes[node][0] / 3;
      y += mesh.nodes[node][1] / 3;
    }
    if (x < 2 || x > 7 || y > 8) kept.push_back(element);
  }
  mesh.elements = kept;
  mesh.element_region.assign(kept.size(), 0);
  finish(mesh);
  const int start = find_element(mesh, {0.5, 0.2});
  const int found = find_element(mesh, {8.5, 0.2}, start);
  ASSERT_GE(found, 0);
  EXPECT_LT(std::abs(get_centroid(mesh, found)[0] - 8.5), 0.5);
  EXPECT_EQ(find_element(mesh, {4.5, 0.2}, start), -1);
}

TEST(Column, OfTwoLayersHasTheHandValueOfItsWeight) {
  Mesh<2> mesh = make_grid(4, 10, 0.5);  // 5 m high; upper half lighter
  finish(mesh);
  std::vector<double> weight(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) weight[e] = get_centroid(mesh, e)[1] > 2.5 ? 18e3 : 21e3;
  // Places on the diagonals, on nodes, on vertical edges and on both borders of this regular mesh are all met.
  std::vector<LocalPoint<2>> points;
  std::vector<double> expected;
  for (double x : {0.0, 0.1, 0.25, 0.5, 0.77, 1.0, 1.3, 2.0})
    for (double y : {0.0, 0.1, 0.25, 1.0, 2.4, 2.5, 3.0, 4.9}) {
      points.push_back(place(mesh, {x, y}));
      expected.push_back(y < 2.5 ? 18e3 * 2.5 + 21e3 * (2.5 - y) : 18e3 * (5 - y));
    }
  const auto computed = overburden_integral(mesh, weight, points, {0, 1});
  for (std::size_t p = 0; p < points.size(); ++p) EXPECT_NEAR(computed[p], expected[p], 1e-3) << p;
}

TEST(Column, OfTheSlopeEndsAtItsSurface) {
  const auto mesh = make_slope();
  const auto weight = weigh(mesh, unit_weight);
  const auto surface = [](double x) { return x < 12 ? 15.0 : (x > 32 ? 5.0 : 15 - (x - 12) / 2); };
  std::vector<LocalPoint<2>> points;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] == 0)
      for (const auto& xi : point_positions<2>(3)) points.push_back({e, xi});
  for (double x : {0.0, 12.0, 32.0, 44.0}) points.push_back(place(mesh, {x, 0.0}));
  const auto computed = overburden_integral(mesh, weight, points, {0, 1});
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto x = to_global(mesh, points[p].element, points[p].xi);
    EXPECT_NEAR(computed[p], unit_weight * (surface(x[0]) - x[1]), 1e-7 * unit_weight * 15) << x[0] << " " << x[1];
  }
}

TEST(Column, IsTheSameForAnyNumberOfThreads) {
  const auto mesh = make_slope();
  std::vector<LocalPoint<2>> points;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const auto& xi : point_positions<2>(12)) points.push_back({e, xi});
  const auto weight = weigh(mesh, unit_weight);
  EXPECT_EQ(overburden_integral(mesh, weight, points, {0, 1}, 1), overburden_integral(mesh, weight, points, {0, 1}, 3));
}

TEST(Column, FollowsTheDirectionItIsGiven) {
  const auto mesh = make_slope();
  const double s = std::sqrt(0.5);
  // From (20, 2) at 45 degrees the surface y = 15 - (x - 12)/2 is met at x = 20 + 6, 6√2 away.
  const auto computed = overburden_integral(mesh, weigh(mesh, 1.0), {place(mesh, {20, 2})}, {s, s});
  EXPECT_NEAR(computed[0], 6 * std::sqrt(2.0), 1e-12);
}

TEST(Column, PassesOverACaveAndAGapOfTheMesh) {
  Mesh<2> mesh = make_grid(3, 6, 1);
  for (int e = 0; e < mesh.element_count(); ++e)  // rows 1 and 2 hold no soil
    if (const int row = e / 6; row == 1 || row == 2) mesh.element_region[e] = empty_region;
  mesh.elements.erase(mesh.elements.begin() + 4 * 6, mesh.elements.begin() + 5 * 6);  // row 4 is not meshed at all
  mesh.element_region.erase(mesh.element_region.begin() + 4 * 6, mesh.element_region.begin() + 5 * 6);
  finish(mesh);
  // Above y = 0.25 there are 0.75 + 1 (row 3) + 1 (row 5) of soil.
  const auto computed =
      overburden_integral(mesh, weigh(mesh, 10.0), {place(mesh, {1.4, 0.25}), place(mesh, {1.0, 0.25})}, {0, 1});
  EXPECT_NEAR(computed[0], 27.5, 1e-12);
  EXPECT_NEAR(computed[1], 27.5, 1e-7);
}

TEST(Column, IsIntegratedInThreeDimensions) {
  Mesh<3> mesh = make_grid(3, 4, 3, 0.5);
  finish(mesh);
  std::vector<LocalPoint<3>> points;
  std::vector<double> expected;
  for (double x : {0.0, 0.2, 0.5, 0.75, 1.5})
    for (double y : {0.0, 0.3, 0.5, 1.9})
      for (double z : {0.0, 0.25, 1.0, 1.31}) {
        points.push_back(place(mesh, {x, y, z}));
        expected.push_back(2 - y);
      }
  const auto computed = overburden_integral(mesh, weigh(mesh, 1.0), points, {0, 1, 0});
  for (std::size_t p = 0; p < points.size(); ++p) EXPECT_NEAR(computed[p], expected[p], 1e-7) << p;
}

}  // namespace
}  // namespace talus::mesh
