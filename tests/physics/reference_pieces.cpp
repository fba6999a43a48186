// SPDX-License-Identifier: MIT
// Parts of the plain step against hand calculations on two triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/bodies.hpp"
#include "reference/plain_mpm.hpp"

namespace talus::reference {
namespace {

// One square divided into two triangles by the diagonal.
Body<2> make_two_triangles() {
  Body<2> body = make_body(make_box<2>({1, 1}, {1, 1}), {.young_modulus = 1e6, .poisson_ratio = 0.3});
  fill(body, 1000.0, 0, [](const Vector<2>&) { return true; });
  return body;
}

TEST(ReferenceSmoothing, TwoTrianglesAverageTwoThirdsToOneThird) {
  Body<2> body = make_two_triangles();
  classify_elements(body, {});
  map_points_to_nodes(body);
  const std::vector<double> smoothed = smooth_over_nodes(body, {1, 0});
  EXPECT_NEAR(smoothed[0], 2.0 / 3, 1e-15);  // its own corner 1, the two common ones a half each
  EXPECT_NEAR(smoothed[1], 1.0 / 3, 1e-15);
}

TEST(ReferenceSmoothing, PlasticDilationStaysWithItsElementAndOnlyWhatIsElasticIsAveraged) {
  Body<2> body = make_two_triangles();
  classify_elements(body, {});
  map_points_to_nodes(body);
  body.plastic_dilation = {0.009, 0};  // at rest all of it is elastic shortening
  compute_strain_increments(body, {.time_step = 0.01, .smoothing = Smoothing::stable});
  // Averaging takes a third of 0.009 from both; a quarter of that comes one step late.
  EXPECT_NEAR(body.cells[0].strain_increment.trace(), 0.003 - 0.003 / 4, 1e-16);
  EXPECT_NEAR(body.cells[1].strain_increment.trace(), -0.003 + 0.003 / 4, 1e-16);
  classify_elements(body, {});
  map_points_to_nodes(body);
  compute_strain_increments(body, {.time_step = 0.01, .smoothing = Smoothing::stable});
  EXPECT_NEAR(body.cells[0].strain_increment.trace(), 0.003, 1e-16) << "what is the same in each step is not held back";
  EXPECT_EQ(body.cells[0].strain_increment(2, 2), 0);
}

TEST(ReferenceSmoothing, OnlyTheVolumetricStrainIsSmoothedAndNoneIsLeftOutOfPlane) {
  Body<2> body = make_two_triangles();
  classify_elements(body, {});
  map_points_to_nodes(body);
  int corner = -1;  // the node of element 0 that element 1 does not have
  for (int i : body.mesh.elements[0])
    if (std::ranges::count(body.mesh.elements[1], i) == 0) corner = i;
  at(body.nodes, corner).velocity = {0.3, 0.1};
  std::vector<Cell> untouched = body.cells;
  compute_strain_increments(body, {.time_step = 0.01, .smoothing = Smoothing::strain});
  std::swap(body.cells, untouched);
  compute_strain_increments(body, {.time_step = 0.01});
  const Tensor rough = body.cells[0].strain_increment, smooth = untouched[0].strain_increment;
  ASSERT_GT(std::abs(rough.trace()), 1e-4);
  EXPECT_NEAR(smooth.trace(), 2.0 / 3 * rough.trace(), 1e-16);
  EXPECT_NEAR(untouched[1].strain_increment.trace(), rough.trace() / 3, 1e-16);
  const Tensor change = smooth - rough;
  EXPECT_NEAR(change(0, 0), -rough.trace() / 6, 1e-16);
  EXPECT_NEAR(change(1, 1), -rough.trace() / 6, 1e-16);
  EXPECT_EQ(change(2, 2), 0);
  EXPECT_EQ(change(0, 1), 0);
}

TEST(ReferenceUpdate, VolumesFollowTheVolumetricStrainUnlessFrozen) {
  Body<2> body = make_two_triangles();
  classify_elements(body, {});
  for (Cell& cell : body.cells) cell.strain_increment = Vector3(0.01, 0.02, 0).asDiagonal();
  update_points(body, {.frozen = true});
  EXPECT_EQ(body.points[0].volume, 1.0 / 6);
  update_points(body, {});
  EXPECT_NEAR(body.points[0].volume, 1.03 / 6, 1e-15);
  EXPECT_NEAR(body.points[0].strain(1, 1), 0.04, 1e-15);
}

TEST(ReferenceUpdate, PointsOfAFullElementHaveItsVolumeWeightedState) {
  Body<2> body = make_two_triangles();
  classify_elements(body, {});
  const double volumes[] = {1, 2, 5};
  const double stresses[] = {-8, 4, 16}, plastic_strains[] = {0.8, 0, 0.16};
  for (std::size_t k = 0; k < 3; ++k) {
    Point<2>& point = body.points[body.cells[0].points[k]];
    point.volume = volumes[k];
    point.sigma(2, 2) = stresses[k];
    point.plastic_strain = plastic_strains[k];
  }
  update_points(body, {});
  for (std::size_t p : body.cells[0].points) {
    EXPECT_NEAR(body.points[p].sigma(2, 2), 10, 1e-12);
    EXPECT_NEAR(body.points[p].plastic_strain, 0.2, 1e-15);
  }
}

TEST(ReferenceFullElements, FreeSurfaceVolumeAndMaterialsDecide) {
  Body<2> body = make_two_triangles();
  const auto is_full = [&](std::size_t e) {
    classify_elements(body, {});
    return body.cells[e].full;
  };
  for (Point<2>& point : body.points) point.volume *= 0.5;
  EXPECT_TRUE(is_full(0));  // the boundary of the mesh is no free surface, however little the element is filled
  std::erase_if(body.points, [](const Point<2>& point) { return point.element == 1; });
  EXPECT_FALSE(is_full(0));  // half filled at a free surface
  for (Point<2>& point : body.points) point.volume *= 2 * 0.901;
  EXPECT_TRUE(is_full(0));
  body.materials.push_back(body.materials[0]);
  body.points[1].material = 1;
  EXPECT_FALSE(is_full(0));
}

TEST(ReferenceFullElements, InternalForceUsesTheWholeVolumeAndTheMeanStress) {
  Body<2> body = make_two_triangles();
  for (Point<2>& point : body.points) point.volume *= 1 + 0.1 * point.id;
  body.points[1].sigma(0, 0) = 700;
  classify_elements(body, {});
  map_points_to_nodes(body);
  const int e = body.points[1].element;
  double volume = 0, pull = 0;
  for (const Point<2>& point : body.points) volume += point.element == e ? point.volume : 0;
  for (const Node<2>& node : body.nodes) pull += std::abs(node.internal_force[0]) / 2;
  // Unit gradient in x over the triangle of area 1/2: the force on either side is σ̄ V_e.
  EXPECT_NEAR(pull, 700 * body.points[1].volume / volume * 0.5, 1e-10);
}

TEST(ReferenceDamping, ForceIsReducedAlongTheMotionAndIncreasedAgainstIt) {
  Body<2> body = make_two_triangles();
  body.gravity = {4, -4};
  for (Point<2>& point : body.points) point.v = {1, 1};
  const Settings settings{.time_step = 1e-3, .damping = 0.25};
  step(body, settings);
  EXPECT_NEAR(body.points[0].v[0], 1 + 1e-3 * 3, 1e-14);
  EXPECT_NEAR(body.points[0].v[1], 1 - 1e-3 * 5, 1e-14);
  for (Point<2>& point : body.points) point.v.setZero();
  step(body, settings);
  EXPECT_NEAR(body.nodes[0].acceleration[0], 4, 1e-12);  // sign(0) = 0
}

TEST(ReferenceConstraints, FixedComponentsAndNormalsTakeAwayTheirMotionOnly) {
  Constraint<3> fixed{.fixed = {true, false, true}};
  EXPECT_EQ(fixed.apply({1, 2, 3}), Vector<3>(0, 2, 0));
  Constraint<2> wall{.normal = Vector<2>(3, 4) / 5};
  EXPECT_LT((wall.apply({1, 0}) - Vector<2>(16, -12) / 25).norm(), 1e-15);
}

TEST(ReferenceRotation, StressTurnsWithTheSoilByTheAngleOfHughesAndWinget) {
  Body<2> body = make_two_triangles();
  Tensor sigma;
  sigma << -4e3, 6e2, 0, 6e2, -1e3, 0, 0, 0, -2e3;
  for (Point<2>& point : body.points) point.sigma = sigma;
  const double spin = 2.0, dt = 0.01;
  const int steps = 40;
  classify_elements(body, {});
  for (Cell& cell : body.cells) {
    cell.gradient(0, 1) = -spin;
    cell.gradient(1, 0) = spin;
  }
  for (int n = 0; n < steps; ++n) update_points(body, {.time_step = dt});
  const double angle = steps * 2 * std::atan(spin * dt / 2);
  const Tensor q = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT((body.points[0].sigma - q * sigma * q.transpose()).norm(), 1e-9);
}

}  // namespace
}  // namespace talus::reference
