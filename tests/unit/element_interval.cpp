// SPDX-License-Identifier: MIT
// The interval of the factor by FEM: hand calculations of (T19.12) and (T19.18), layers too thin for it, and the
// elements to refine.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/bisect.hpp"
#include "mesh/generate.hpp"
#include "run/fem/adapted_mesh.hpp"
#include "run/fem/element_run.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {
namespace {

results::ElementMeshFactor make_factor(double size, double stable, double failed, std::optional<double> flowing) {
  return {size, 0.5 * (stable + failed), stable, failed, flowing};
}

TEST(ElementInterval, ReachesFromTheFineFactorDownByThreeTimesWhatTheExtrapolationTakes) {
  const auto interval = find_mesh_interval(make_factor(2, 1.448, 1.452, 1.452), make_factor(1, 1.414, 1.418, 1.418));
  ASSERT_TRUE(interval.has_value());
  EXPECT_NEAR(interval->lower, 1.416 - 3 * 0.034 - 0.006, 1e-12) << "brackets: 0.006";
  EXPECT_NEAR(interval->upper, 1.418, 1e-12) << "the flowing trial of the fine mesh";
}

TEST(ElementInterval, OfMeshesWhoseSizesAreCloserReachesFarther) {
  const auto fine = make_factor(1, 1.414, 1.418, 1.418);
  EXPECT_NEAR(find_mesh_interval(make_factor(1.5, 1.448, 1.452, 1.452), fine)->lower, 1.414 - 2 * (0.038 + 2 * 0.034),
              1e-12);
}

TEST(ElementInterval, OfMeshesThatAgreeByChanceHoldsTheirScatter) {
  const auto fine = make_factor(1, 1.414, 1.418, 1.418);
  const auto interval = find_mesh_interval(make_factor(2, 1.414, 1.418, 1.418), fine);
  EXPECT_NEAR(interval->lower, 1.414 - known_scatter * 1.416, 1e-12);
  EXPECT_NEAR(find_mesh_interval(make_factor(2, 1.414, 1.418, 1.418), fine, {0.05, 0.006})->lower, 1.414 - 0.05 * 1.416,
              1e-12);
  EXPECT_NEAR(find_mesh_interval(make_factor(2, 1.414, 1.418, 1.418), fine, {0.05, 0.006})->upper,
              1.418 + 0.006 * 1.416, 1e-12);
}

TEST(ElementInterval, ReachesAboveTheFineFactorWhereTheCoarseOneIsLower) {
  const auto interval = find_mesh_interval(make_factor(2, 1.380, 1.384, 1.384), make_factor(1, 1.414, 1.418, 1.418));
  EXPECT_NEAR(interval->upper, 1.418 + (1.418 - 1.380), 1e-12);
  EXPECT_NEAR(interval->lower, 1.414 - known_scatter * 1.416, 1e-12);
}

TEST(ElementInterval, ExtendsOverUndecidedTrialsToTheNextThatFlows) {
  const auto interval = find_mesh_interval(make_factor(2, 1.448, 1.452, 1.468), make_factor(1, 1.414, 1.418, 1.438));
  EXPECT_NEAR(interval->upper, 1.438, 1e-12);
  EXPECT_NEAR(interval->lower, 1.414 - (1.468 - 1.414) - 2 * 0.034, 1e-12);
  EXPECT_FALSE(find_mesh_interval(make_factor(2, 1.448, 1.452, {}), make_factor(1, 1.414, 1.418, 1.418)).has_value())
      << "no trial of the coarse mesh flows";
}

/// Factors 1 + 0.1 h^p on meshes of 4, 2 and 1 m, with brackets of 0.002.
std::vector<results::ElementMeshFactor> make_sequence(double order) {
  std::vector<results::ElementMeshFactor> meshes;
  for (const double h : {4.0, 2.0, 1.0}) {
    const double factor = 1 + 0.1 * std::pow(h, order);
    meshes.push_back(make_factor(h, factor - 0.001, factor + 0.001, factor + 0.001));
  }
  return meshes;
}

TEST(ElementSequence, OfFirstOrderHasTheSafetyFactorOfThreeGrids) {
  const auto meshes = make_sequence(1);
  EXPECT_NEAR(compute_order(meshes), 1, 1e-9);
  const auto interval = find_sequence_interval(meshes);
  EXPECT_NEAR(interval->lower, 1.1 - 1.25 * 0.1 - 0.003, 1e-9) << "brackets: 0.001 + 0.002";
  EXPECT_NEAR(interval->upper, 1.101, 1e-12) << "the flowing trial of the finest mesh";
  EXPECT_NEAR(find_sequence_interval(meshes, {}, mesh_safety)->lower, 1.1 - 3 * 0.1 - 0.003, 1e-9) << "ψ < φ";
}

TEST(ElementSequence, HoldsTheLimitForEveryOrderThatItShows) {
  for (const double order : {0.2, 0.4, 0.6, 0.8, 1.0, 1.5, 2.0}) {
    const auto meshes = make_sequence(order);
    EXPECT_NEAR(compute_order(meshes), std::min(order, 1.0), 1e-9);
    const auto interval = find_sequence_interval(meshes);
    EXPECT_LT(interval->lower, 1) << order;
    EXPECT_GT(interval->upper, 1) << order;
  }
}

TEST(ElementSequence, OfMeshesThatAgreeByChanceKeepsTheEarlierDifference) {
  auto meshes = make_sequence(1);
  meshes.back() = make_factor(1, 1.199, 1.201, 1.201);
  EXPECT_NEAR(find_sequence_interval(meshes)->lower, 1.199 - 1.25 * 0.1, 1e-9) << "half of 0.2";
}

TEST(ElementSequence, WithoutOrderIsWide) {
  auto meshes = make_sequence(1);
  meshes.front() = make_factor(4, 1.199, 1.201, 1.201);  // the first difference is 0, the second 0.1
  const double rest = 1 / (std::pow(2, 0.1) - 1);
  EXPECT_NEAR(find_sequence_interval(meshes)->lower, std::max(0.0, 1.099 - rest * (0.102 + 0.25 * 0.1)), 1e-9);
  meshes.erase(meshes.begin());
  EXPECT_EQ(find_sequence_interval(meshes)->lower, find_mesh_interval(meshes[0], meshes[1])->lower) << "two meshes";
}

/// Elements of 1 m, of which those below y = 1 yield and strain by `strain` at a shear stress of 1 Pa.
struct Sheared {
  mesh::Mesh<2> mesh;
  fem::QuadraticMesh<2> quadratic;
  std::vector<double> work;

  explicit Sheared(double strain) {
    mesh::Plan plan;
    plan.box_max = {10, 5};
    plan.size = 1;
    plan.polygons = {{"seam", {{0, 0}, {10, 0}, {10, 1}, {0, 1}}}, {"soil", {{0, 1}, {10, 1}, {10, 5}, {0, 5}}}};
    mesh = mesh::generate<2>(plan);
    quadratic = fem::make_quadratic<2>(mesh);
    fem::SolidState<2> failure, motion;
    failure.stress.assign(quadratic.points.size(), {-5, -5, -5, 1, 0, 0});
    motion.strain.assign(quadratic.points.size(), {0.1, 0.1, 0.1, strain, 0, 0});
    for (const auto& x : quadratic.points) failure.yields.push_back(x[1] < 1 ? 1 : 0);
    work = compute_shear_work(quadratic, failure, motion);
  }
  bool is_seam(std::size_t e) const { return mesh.region_names[mesh.element_region[e]] == "seam"; }
};

TEST(AdaptedMesh, ShearWorkIsThatOfTheDeviatorWhereSoilYields) {
  const Sheared sheared(0.2);
  double sum = 0;
  for (const double w : sheared.work) sum += w;
  EXPECT_NEAR(sum, 0.2 * 10, 1e-9) << "γ times area; the mean stress does no shear work";
  const double size = compute_shear_size(sheared.mesh, sheared.quadratic, sheared.work);
  const auto finer = mesh::refine(sheared.mesh, std::vector<bool>(sheared.mesh.elements.size(), true));
  EXPECT_NEAR(compute_shear_size(finer, fem::make_quadratic<2>(finer), finer.volumes),
              0.5 * compute_shear_size(sheared.mesh, sheared.quadratic, sheared.mesh.volumes), 1e-9);
  EXPECT_NEAR(size, 0.8, 0.1) << "two rows of triangles in the seam";
  EXPECT_EQ(compute_shear_size(sheared.mesh, sheared.quadratic, Sheared(0).work), 0);
}

TEST(AdaptedMesh, RefinesTheElementsThatShearAndTheirNeighbours) {
  const Sheared sheared(0.2);
  const auto marked = mark_shear(sheared.mesh, sheared.quadratic, sheared.work, 100000);
  ASSERT_TRUE(marked.has_value());
  std::size_t seam = 0, found = 0;
  for (std::size_t e = 0; e < marked->size(); ++e) {
    seam += sheared.is_seam(e), found += sheared.is_seam(e) && (*marked)[e];
    const auto& beside = sheared.mesh.neighbours[e];
    const bool touches = std::any_of(beside.begin(), beside.end(), [&](int other) {
      return other >= 0 && sheared.is_seam(static_cast<std::size_t>(other));
    });
    EXPECT_TRUE(touches || sheared.is_seam(e) || !(*marked)[e]) << "neither the seam nor beside it";
  }
  EXPECT_GE(static_cast<double>(found), 0.9 * static_cast<double>(seam));
  EXPECT_FALSE(mark_shear(sheared.mesh, sheared.quadratic, sheared.work, sheared.mesh.elements.size() + 10).has_value())
      << "no elements are left";
  EXPECT_FALSE(mark_shear(sheared.mesh, sheared.quadratic, Sheared(0).work, 100000).has_value()) << "nothing shears";
}

/// A block of 10 m × 5 m over a seam of 0.5 m, and strains of 1 in one of them.
std::vector<std::string> list_thin(double size, const std::string& sheared, bool is_adapted = false) {
  mesh::Plan plan;
  plan.box_max = {10, 5.5};
  plan.size = size;
  plan.polygons = {{"seam", {{0, 0}, {10, 0}, {10, 0.5}, {0, 0.5}}},
                   {"soil", {{0, 0.5}, {10, 0.5}, {10, 5.5}, {0, 5.5}}}};
  const auto mesh = mesh::generate<2>(plan);
  const auto quadratic = fem::make_quadratic<2>(mesh);
  fem::SolidState<2> motion;
  motion.strain.assign(quadratic.points.size(), {});
  for (std::size_t i = 0; i < motion.strain.size(); ++i) {
    const int e = quadratic.linear_element[i / 3];
    if (mesh.region_names[static_cast<std::size_t>(mesh.element_region[e])] == sheared) motion.strain[i][3] = 1;
  }
  return list_thin_layers(mesh, quadratic, motion, is_adapted);
}

TEST(ThinLayers, AreThoseThatShearWithFewRowsOfElements) {
  EXPECT_EQ(list_thin(0.5, "seam"), std::vector<std::string>{"seam"});
  EXPECT_EQ(list_thin(0.5, "soil"), std::vector<std::string>{}) << "the seam stays elastic, the block is thick";
  EXPECT_EQ(list_thin(0.11, "seam"), std::vector<std::string>{}) << "five rows";
  EXPECT_EQ(list_thin(0.5, "seam", true), std::vector<std::string>{"seam"});
  EXPECT_EQ(list_thin(0.11, "seam", true), std::vector<std::string>{});
}

}  // namespace
}  // namespace talus::run
