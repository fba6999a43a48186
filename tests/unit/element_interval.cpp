// SPDX-License-Identifier: MIT
// The interval of the factor by FEM: hand calculations of (T19.12), and layers too thin for it.

#include <gtest/gtest.h>

#include "mesh/generate.hpp"
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

/// A block of 10 m × 5 m over a seam of 0.5 m, and strains of 1 in one of them.
std::vector<std::string> list_thin(double size, const std::string& sheared) {
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
  return list_thin_layers(mesh, quadratic, motion);
}

TEST(ThinLayers, AreThoseThatShearWithFewRowsOfElements) {
  EXPECT_EQ(list_thin(0.5, "seam"), std::vector<std::string>{"seam"});
  EXPECT_EQ(list_thin(0.5, "soil"), std::vector<std::string>{}) << "the seam stays elastic, the block is thick";
  EXPECT_EQ(list_thin(0.11, "seam"), std::vector<std::string>{}) << "five rows";
}

}  // namespace
}  // namespace talus::run
