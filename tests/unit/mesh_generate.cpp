// SPDX-License-Identifier: MIT
// Meshes by Gmsh: published size, conformity to layers and lines, refinement, extrusion, reproducibility.

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "mesh/quality.hpp"
#include "mesh_grid.hpp"
#include "slope_plan.hpp"

namespace talus::mesh {
namespace {

double measure_area(const Mesh<3>& mesh, const std::string& name) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.sides.at(name)) {
    const auto &p = mesh.nodes[a], &q = mesh.nodes[b], &r = mesh.nodes[c];
    const double u[3]{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v[3]{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return area;
}

/// Every named side is a side of some element.
template <int D>
void expect_conforming_sides(const Mesh<D>& mesh) {
  std::set<std::array<int, D>> all;
  for (const auto& element : mesh.elements)
    for (int k = 0; k <= D; ++k) {
      std::array<int, D> side;
      for (int i = 0, j = 0; i <= D; ++i)
        if (i != k) side[j++] = element[i];
      std::sort(side.begin(), side.end());
      all.insert(side);
    }
  for (const auto& [name, sides] : mesh.sides)
    for (auto side : sides) {
      std::sort(side.begin(), side.end());
      ASSERT_TRUE(all.contains(side)) << name;
    }
}

TEST(Generate, MakesTheDrySlopeOfThePublishedSizeFromWellShapedElements) {
  for (Algorithm algorithm : {Algorithm::frontal, Algorithm::delaunay, Algorithm::meshadapt}) {
    Plan plan = plan_slope(0.75);
    plan.algorithm = algorithm;
    const auto mesh = generate<2>(plan);
    const auto soil = measure_quality(mesh), all = measure_quality(mesh, false);
    EXPECT_NEAR(soil.element_count, 1792, 0.03 * 1792);  // published 1,792 and 3,066
    EXPECT_NEAR(all.element_count, 3066, 0.03 * 3066);
    EXPECT_GT(soil.min_altitude, 0.45);  // the published run's step follows from about 0.41 m
    EXPECT_GT(all.min_altitude, 0.44);
    EXPECT_GT(soil.min_angle, 18 * 0.0174533);
    EXPECT_NEAR(sum_region(mesh, 0), 440, 1e-9 * 440);
    EXPECT_NEAR(sum_region(mesh, empty_region), 44 * 17 - 440, 1e-9 * 440);
    for (int e = 0; e < mesh.element_count(); ++e)
      ASSERT_EQ(mesh.element_region[e] == 0, is_inside(get_centroid(mesh, e), plan.polygons[0].points));
    EXPECT_NEAR(measure_length(mesh, "left"), 17, 1e-12);
    EXPECT_NEAR(measure_length(mesh, "right"), 17, 1e-12);
    EXPECT_NEAR(measure_length(mesh, "bottom"), 44, 1e-12);
    EXPECT_NEAR(measure_length(mesh, "top"), 44, 1e-12);
    expect_conforming_sides(mesh);
  }
}

TEST(Generate, ConformsToLayersLensesAndLinesThatCrossThem) {
  Plan plan;
  plan.box_min = {-1, 0};
  plan.box_max = {20, 12};
  plan.size = 1;
  plan.polygons = {{"upper", {{0, 5}, {18, 5}, {18, 7}, {10, 10}, {0, 10}}},  // a part of an edge is common with
                   {"lower", {{-1, 0}, {20, 0}, {20, 5}, {-1, 5}}},           // this one, which fills the box's width
                   {"lens", {{4, 6}, {8, 6}, {6, 8}}},                        // wholly inside "upper"
                   {"notch", {{10, 0}, {12, 0}, {11, 2}}}};                   // inside "lower", on its edge
  plan.lines = {{"pipe", {{2, 1}, {2, 9}, {7, 7}}},                           // through layers, ends within the lens
                {"roof", {{10, 10}, {18, 7}}},                                // an edge of a polygon
                {"inlet", {{3, 0}, {5, 0}}},                                  // a part of the box's bottom
                {"cross", {{1, 3}, {9, 3}}}};                                 // crosses "pipe"
  const auto mesh = generate<2>(plan);
  const double lens = 4, notch = 2, upper = 10 * 5 + (5 + 2) * 8 / 2.0 - lens, lower = 21 * 5 - notch;
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"upper", "lower", "lens", "notch"}));
  EXPECT_NEAR(sum_region(mesh, 0), upper, 1e-9 * upper);
  EXPECT_NEAR(sum_region(mesh, 1), lower, 1e-9 * lower);
  EXPECT_NEAR(sum_region(mesh, 2), lens, 1e-9);
  EXPECT_NEAR(sum_region(mesh, 3), notch, 1e-9);
  EXPECT_NEAR(sum_region(mesh, empty_region), 21 * 12 - upper - lower - lens - notch, 1e-7);
  EXPECT_NEAR(measure_length(mesh, "pipe"), 8 + std::hypot(5, 2), 1e-9);
  EXPECT_NEAR(measure_length(mesh, "roof"), std::hypot(8, 3), 1e-9);
  EXPECT_NEAR(measure_length(mesh, "inlet"), 2, 1e-9);
  EXPECT_NEAR(measure_length(mesh, "cross"), 8, 1e-9);
  EXPECT_NEAR(measure_length(mesh, "bottom"), 21, 1e-9);  // holds the inlet as well
  for (const auto& side : mesh.sides.at("pipe"))
    for (int node : side)
      EXPECT_LT(compute_distance({mesh.nodes[node][0], mesh.nodes[node][1]}, plan.lines[0].points), 1e-9);
  expect_conforming_sides(mesh);
}

TEST(Generate, MeshesAnEmptyBox) {
  Plan plan;
  plan.box_max = {3, 2};
  plan.size = 0.5;
  const auto mesh = generate<2>(plan);
  EXPECT_NEAR(sum_region(mesh, empty_region), 6, 1e-12);
  EXPECT_TRUE(mesh.region_names.empty());
}

TEST(Generate, RefinesTheGivenPlacesOnly) {
  Plan plan = plan_slope(1.5);
  plan.refinements = {{{{12, 15}, {32, 5}}, 0.4, 6}, {{{2, 2}}, 0.3, 4}};
  const auto mesh = generate<2>(plan);
  double near = 0, point = 0, far = 0;
  int near_count = 0, point_count = 0, far_count = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const Point2 x = get_centroid(mesh, e);
    const double edge = std::sqrt(mesh.volumes[e] * 4 / std::sqrt(3.0));
    const double to_line = compute_distance(x, plan.refinements[0].near),
                 to_point = compute_distance(x, {2, 2}, {2, 2});
    if (to_line < 0.3) near += edge, ++near_count;
    if (to_point < 0.4) point += edge, ++point_count;
    if (to_line > 7 && to_point > 5) far += edge, ++far_count;
  }
  ASSERT_GT(near_count, 50);
  ASSERT_GT(point_count, 4);
  EXPECT_NEAR(near / near_count, 0.42, 0.08);
  EXPECT_NEAR(point / point_count, 0.38, 0.1);
  EXPECT_NEAR(far / far_count, 1.5, 0.25);
  EXPECT_NEAR(sum_region(mesh, 0), 440, 1e-9 * 440);
}

TEST(Generate, KeepsSmallAndFarGeometryExact) {
  Plan small;  // the centrifuge model, in metres
  small.box_max = {0.8, 0.52};
  small.size = 0.032;
  small.polygons = {{"soil", {{0, 0}, {.8, 0}, {.8, .48}, {.6, .48}, {.2, .08}, {0, .08}}}};
  small.lines = {{"inlet", {{0.7, 0}, {0.8, 0}}}};
  const auto mesh = generate<2>(small);
  const double area = compute_area(small.polygons[0].points);
  EXPECT_NEAR(sum_region(mesh, 0), area, 1e-9 * area);
  EXPECT_NEAR(measure_length(mesh, "inlet"), 0.1, 1e-10);

  Plan far = plan_slope(1.5);  // map coordinates
  const auto move = [](Point2& x) { x = {x[0] + 650000, x[1] + 800}; };
  move(far.box_min);
  move(far.box_max);
  for (auto& x : far.polygons[0].points) move(x);
  const auto moved = generate<2>(far);
  EXPECT_NEAR(sum_region(moved, 0), 440, 1e-8 * 440);
  EXPECT_GT(measure_quality(moved).min_altitude, 0.85);
  // The same section has the same mesh wherever it lies.
  const auto here = generate<2>(plan_slope(1.5));
  ASSERT_EQ(moved.elements, here.elements);
  for (std::size_t i = 0; i < here.nodes.size(); ++i) {
    EXPECT_NEAR(moved.nodes[i][0] - 650000, here.nodes[i][0], 1e-9);
    EXPECT_NEAR(moved.nodes[i][1] - 800, here.nodes[i][1], 1e-9);
  }
}

void expect_same_mesh(const Mesh<2>& there, const Mesh<2>& here, const Point2& moved) {
  ASSERT_EQ(there.elements, here.elements);
  for (std::size_t i = 0; i < here.nodes.size(); ++i)
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(there.nodes[i][d] - moved[d], here.nodes[i][d], 1e-9);
}

/// Corners to the micrometre, none of which is a binary number: at map coordinates their differences are others.
TEST(Generate, TheMeshDependsNeitherOnTheDatumNorOnTheOrderOfThePolygons) {
  Plan plan;
  plan.box_max = {99.913, 15.1};
  plan.size = 1.3;
  plan.polygons = {{"lower", {{0, 0}, {99.913, 0}, {99.913, 8.121}, {38.004143, 4.019685}, {24.156, 0.7}, {0, 0.7}}},
                   {"upper", {{99.913, 8.121}, {99.913, 13.42}, {70.389, 13.42}, {38.004143, 4.019685}}},
                   {"lens", {{60.1, 7.3}, {66.7, 7.7}, {63.3, 8.9}}}};
  plan.lines = {{"ground", {{24.156, 0.7}, {38.004143, 4.019685}, {70.389, 13.42}}}, {"drain", {{20.3, 0}, {30.7, 0}}}};
  const Mesh<2> here = generate<2>(plan);

  for (const Point2 origin : {Point2{5e5, 850}, Point2{0, 200}, Point2{6329700.3, 300}}) {
    Plan moved = plan;
    const auto move = [&](Point2& x) { x = {x[0] + origin[0], x[1] + origin[1]}; };
    for (Polygon& p : moved.polygons) std::for_each(p.points.begin(), p.points.end(), move);
    for (Line& l : moved.lines) std::for_each(l.points.begin(), l.points.end(), move);
    move(moved.box_min), move(moved.box_max);
    expect_same_mesh(generate<2>(moved), here, origin);
  }

  Plan in_feet = plan;  // a multiple of the size must not become one more or one less
  constexpr double foot = 0.3048;
  in_feet.size = plan.size / foot * foot * (1 + 1e-15);
  for (Polygon& p : in_feet.polygons)
    for (Point2& x : p.points) x = {x[0] / foot * foot, x[1] / foot * foot};
  expect_same_mesh(generate<2>(in_feet), here, {0, 0});

  Plan turned = plan;
  for (std::size_t i = 0; i < 3; ++i) {
    auto& points = turned.polygons[i].points;
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i) + 1, points.end());
    if (i != 1) std::reverse(points.begin(), points.end());
  }
  std::reverse(turned.polygons.begin(), turned.polygons.end());
  std::reverse(turned.lines.begin(), turned.lines.end());
  for (Line& l : turned.lines) std::reverse(l.points.begin(), l.points.end());
  const Mesh<2> other = generate<2>(turned);
  expect_same_mesh(other, here, {0, 0});
  EXPECT_EQ(other.region_names, (std::vector<std::string>{"lens", "upper", "lower"}));
  for (int region = 0; region < 3; ++region) EXPECT_NEAR(sum_region(other, 2 - region), sum_region(here, region), 1e-9);
}

/// Returns the mirror image of a plan about x = sum/2.
Plan reflect(Plan plan, double sum) {
  const auto turn = [&](Polyline& points) {
    for (Point2& x : points) x[0] = sum - x[0];
  };
  for (Polygon& p : plan.polygons) turn(p.points);
  for (Line& l : plan.lines) turn(l.points);
  for (Refinement& r : plan.refinements) turn(r.near);
  const double left = sum - plan.box_max[0];
  plan.box_max[0] = sum - plan.box_min[0];
  plan.box_min[0] = left;
  return plan;
}

/// The mesh of a mirror image is the mirrored mesh, with the same numbers: on a slope, and on level ground where only a
/// lens, a line or a refinement has a side.
TEST(Generate, MirroredSectionsHaveMirroredMeshes) {
  Plan slope;
  slope.box_max = {99.913, 15.1};
  slope.size = 2.6;
  slope.polygons = {{"lower", {{0, 0}, {99.913, 0}, {99.913, 8.121}, {38.004143, 4.019685}, {24.156, 0.7}, {0, 0.7}}},
                    {"upper", {{99.913, 8.121}, {99.913, 13.42}, {70.389, 13.42}, {38.004143, 4.019685}}}};
  slope.lines = {{"drain", {{20.3, 0}, {30.7, 0}}}};
  Plan level;
  level.box_max = {40, 10};
  level.size = 1.7;
  level.polygons = {{"soil", {{0, 0}, {40, 0}, {40, 10}, {0, 10}}}};
  Plan with_lens = level, with_line = level, refined = level;
  with_lens.polygons.push_back({"lens", {{6.1, 4.3}, {12.7, 4.7}, {9.3, 6.9}}});
  with_line.lines = {{"wall", {{13.3, 10}, {13.3, 4.1}}}};
  refined.refinements = {{{{27.3, 10}}, 0.6, 6}};
  for (const Plan& plan : {slope, with_lens, with_line, refined})
    for (const double sum : {plan.box_max[0], 0.0}) {
      const Mesh<2> here = generate<2>(plan), there = generate<2>(reflect(plan, sum));
      ASSERT_EQ(there.nodes.size(), here.nodes.size());
      ASSERT_EQ(there.elements.size(), here.elements.size());
      for (std::size_t i = 0; i < here.nodes.size(); ++i) {
        EXPECT_NEAR(sum - there.nodes[i][0], here.nodes[i][0], 1e-9);
        EXPECT_NEAR(there.nodes[i][1], here.nodes[i][1], 1e-9);
      }
      for (std::size_t e = 0; e < here.elements.size(); ++e) {
        const auto [a, b, c] = here.elements[e];
        EXPECT_EQ(there.elements[e], (std::array{a, c, b}));
      }
      EXPECT_EQ(there.element_region, here.element_region);
      EXPECT_EQ(there.sides.at("left"), here.sides.at("right"));
      EXPECT_EQ(there.sides.at("right"), here.sides.at("left"));
      EXPECT_EQ(there.sides.at("top"), here.sides.at("top"));
    }
}

TEST(Generate, ExtrudesSoilAndWallsIntoTetrahedra) {
  Plan plan = plan_slope(2);
  plan.dimension = 3;
  plan.thickness = 5;
  plan.polygons.push_back({"lens", {{3, 3}, {9, 3}, {9, 8}, {3, 8}}});
  plan.lines = {{"wall", {{20, 2}, {24, 6}}}, {"inlet", {{30, 0}, {36, 0}}}};
  const auto mesh = generate<3>(plan);
  EXPECT_NEAR(sum_region(mesh, 0), (440 - 30) * 5, 1e-9 * 2200);
  EXPECT_NEAR(sum_region(mesh, 1), 30 * 5, 1e-9 * 2200);
  EXPECT_NEAR(sum_region(mesh, empty_region), (44 * 17 - 440) * 5, 1e-9 * 2200);
  EXPECT_NEAR(measure_area(mesh, "front"), 44 * 17, 1e-9 * 748);
  EXPECT_NEAR(measure_area(mesh, "back"), 44 * 17, 1e-9 * 748);
  EXPECT_NEAR(measure_area(mesh, "left"), 17 * 5, 1e-9 * 85);
  EXPECT_NEAR(measure_area(mesh, "top"), 44 * 5, 1e-9 * 220);
  EXPECT_NEAR(measure_area(mesh, "wall"), std::sqrt(32.0) * 5, 1e-9 * 30);
  EXPECT_NEAR(measure_area(mesh, "inlet"), 6 * 5, 1e-9 * 30);
  for (const auto& side : mesh.sides.at("back"))
    for (int node : side) ASSERT_EQ(mesh.nodes[node][2], 5);
  expect_conforming_sides(mesh);
  EXPECT_GT(measure_quality(mesh, false).min_altitude, 0.3 * plan.size);
}

TEST(Generate, MakesTheSameMeshEveryTimeAndFromEveryThread) {
  const Plan plan = plan_slope(1);
  const auto first = generate<2>(plan);
  Plan other = plan;
  other.dimension = 3;
  other.thickness = 2;
  generate<3>(other);  // whatever Gmsh keeps of it must not show
  std::vector<Mesh<2>> meshes(3);
  std::vector<std::thread> threads;
  for (auto& mesh : meshes) threads.emplace_back([&] { mesh = generate<2>(plan); });
  for (auto& thread : threads) thread.join();
  for (const auto& mesh : meshes) {
    EXPECT_EQ(mesh.nodes, first.nodes);
    EXPECT_EQ(mesh.elements, first.elements);
    EXPECT_EQ(mesh.sides, first.sides);
  }
}

TEST(Generate, LeavesTheNumberOfThreadsAlone) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(7);
  generate<2>(plan_slope(3));
  EXPECT_EQ(omp_get_max_threads(), 7);
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace talus::mesh
