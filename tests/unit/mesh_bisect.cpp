// SPDX-License-Identifier: MIT
// Refined meshes: conformity, areas of regions, named sides, and angles.

#include "mesh/bisect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/generate.hpp"
#include "mesh/quality.hpp"

namespace talus::mesh {
namespace {

/// Two soils below air in a box of 6 m × 4 m, with a line inside the upper soil.
Mesh<2> make_section() {
  Plan plan;
  plan.box_max = {6, 4};
  plan.size = 0.8;
  plan.polygons = {{"rock", {{0, 0}, {6, 0}, {6, 1}, {0, 1}}},
                   {"soil", {{0, 1}, {6, 1}, {6, 2}, {4, 2}, {2, 3.5}, {0, 3.5}}}};
  plan.lines = {{"ground", {{0, 3.5}, {2, 3.5}, {4, 2}, {6, 2}}}, {"wall", {{1, 3.5}, {1, 1.5}}}};
  return generate<2>(plan);
}

/// Marks the elements within 1 m of a point.
std::vector<bool> mark_near(const Mesh<2>& mesh, const std::array<double, 2>& x) {
  std::vector<bool> marked;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto centre = to_global(mesh, e, {1.0 / 3, 1.0 / 3});
    marked.push_back(std::hypot(centre[0] - x[0], centre[1] - x[1]) < 1);
  }
  return marked;
}

std::map<int, double> sum_areas(const Mesh<2>& mesh) {
  std::map<int, double> areas;
  for (int e = 0; e < mesh.element_count(); ++e) areas[mesh.element_region[e]] += mesh.volumes[e];
  return areas;
}

double sum_lengths(const Mesh<2>& mesh, const std::string& name) {
  double length = 0;
  for (const auto& [a, b] : mesh.sides.at(name))
    length += std::hypot(mesh.nodes[a][0] - mesh.nodes[b][0], mesh.nodes[a][1] - mesh.nodes[b][1]);
  return length;
}

/// Returns the number of nodes inside an edge of an element, which a conforming mesh does not have.
int count_hanging(const Mesh<2>& mesh) {
  int hanging = 0;
  for (const auto& t : mesh.elements)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = mesh.nodes[t[i]], &b = mesh.nodes[t[(i + 1) % 3]];
      for (const auto& x : mesh.nodes) {
        const double ab = std::hypot(b[0] - a[0], b[1] - a[1]), ax = std::hypot(x[0] - a[0], x[1] - a[1]),
                     xb = std::hypot(b[0] - x[0], b[1] - x[1]);
        if (ax > 1e-9 && xb > 1e-9 && ax + xb < ab + 1e-9) ++hanging;
      }
    }
  return hanging;
}

TEST(MeshBisect, RefinedMeshConformsAndKeepsRegionsAndSides) {
  const Mesh<2> mesh = make_section();
  const auto areas = sum_areas(mesh);
  const double angle = measure_quality(mesh, false).min_angle;
  Mesh<2> finer = mesh;
  for (int times = 0; times < 3; ++times) finer = refine(finer, mark_near(finer, {3, 2.75}));
  EXPECT_GT(finer.element_count(), 2 * mesh.element_count());
  EXPECT_EQ(count_hanging(finer), 0);
  for (const auto& [region, area] : sum_areas(finer)) EXPECT_NEAR(area, areas.at(region), 1e-9 * area) << region;
  EXPECT_EQ(finer.region_names, mesh.region_names);
  ASSERT_EQ(finer.sides.size(), mesh.sides.size());
  for (const auto& [name, sides] : mesh.sides)
    EXPECT_NEAR(sum_lengths(finer, name), sum_lengths(mesh, name), 1e-9) << name;
  EXPECT_GE(measure_quality(finer, false).min_angle, 0.5 * angle * (1 - 1e-9)) << "Rivara's bound";
}

TEST(MeshBisect, MarkedElementsHaveHalfTheSize) {
  const Mesh<2> mesh = make_section();
  const Mesh<2> finer = refine(mesh, std::vector<bool>(mesh.elements.size(), true));
  EXPECT_EQ(finer.element_count(), 4 * mesh.element_count());
  EXPECT_NEAR(measure_quality(finer).mean_size, 0.5 * measure_quality(mesh).mean_size, 1e-12);
  EXPECT_EQ(refine(mesh, std::vector<bool>(mesh.elements.size(), false)).nodes, mesh.nodes) << "nothing is marked";
}

TEST(MeshBisect, PartsHaveTheWeightsOfTheirCorners) {
  const Mesh<2> mesh = make_section();
  Bisector bisector(mesh.nodes, mesh.elements);
  for (std::size_t e = 0; e < mesh.elements.size(); e += 3) bisector.mark(bisector.find_longest(mesh.elements[e]));
  const Bisection parts = bisector.run(true);
  for (std::size_t e = 0; e < parts.triangles.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d) {
        double x = 0;
        for (std::size_t k = 0; k < 3; ++k)
          x += parts.weights[e][i][k] * mesh.nodes[mesh.elements[parts.parent[e]][k]][d];
        EXPECT_NEAR(parts.nodes[parts.triangles[e][i]][d], x, 1e-12);
      }
}

}  // namespace
}  // namespace talus::mesh
