// SPDX-License-Identifier: MIT
// The plain step, the reference of the MPM step, against exact solutions and conservation laws.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include "reference/bodies.hpp"
#include "reference/plain_mpm.hpp"

namespace talus::reference {
namespace {

template <class Dimension>
class ReferenceStep : public ::testing::Test {
 protected:
  static constexpr int dimension = Dimension::value;
  static std::array<double, dimension> box_size() {
    std::array<double, dimension> size{};
    for (int d = 0; d < dimension; ++d) at(size, d) = d == 0 ? 2.0 : 1.5;
    return size;
  }
  static mesh::Mesh<dimension> make_mesh() {
    std::array<int, dimension> cells{};
    cells.fill(dimension == 2 ? 8 : 4);
    return make_box<dimension>(cells, box_size());
  }
  static Material make_elastic() { return {.young_modulus = 1e6, .poisson_ratio = 0.3}; }
};

using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ReferenceStep, Dimensions);

TYPED_TEST(ReferenceStep, ThrownBodyFollowsTheParabolaOfTheScheme) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>& x) { return (x - Vector<D>::Constant(0.7)).norm() < 0.35; });
  body.gravity[1] = -9.81;
  Vector<D> v0 = Vector<D>::Constant(0.2);
  v0[1] = 1.5;
  for (Point<D>& point : body.points) point.v = v0;
  const std::vector<Point<D>> start = body.points;
  const int steps = 200;
  const double dt = 2e-3;
  for (int n = 0; n < steps; ++n) step(body, {.time_step = dt, .smoothing = Smoothing::stable});
  ASSERT_EQ(body.points.size(), start.size());
  // x_N = x_0 + Σ_{n=1..N} Δt (v_0 + nΔt g)
  const Vector<D> x_change = steps * dt * v0 + dt * dt * steps * (steps + 1) / 2 * body.gravity;
  int moved = 0;
  for (std::size_t p = 0; p < start.size(); ++p) {
    EXPECT_LT((body.points[p].v - v0 - steps * dt * body.gravity).norm(), 1e-11);
    EXPECT_LT((body.points[p].x - start[p].x - x_change).norm(), 1e-11);
    EXPECT_LT(body.points[p].sigma.norm(), 1e-4);  // round-off of 1e6 Pa over 200 steps
    moved += body.points[p].element != start[p].element;
  }
  EXPECT_GT(moved, 0);
}

template <int D>
Vector<D> sum_momentum(const Body<D>& body) {
  Vector<D> sum = Vector<D>::Zero();
  for (const Point<D>& point : body.points) sum += point.mass * point.v;
  return sum;
}

template <int D>
void randomise_velocity(Body<D>& body, double speed) {
  std::mt19937 random(3);
  for (Point<D>& point : body.points)
    for (int d = 0; d < D; ++d)
      point.v[d] = speed * (2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1);
}

TYPED_TEST(ReferenceStep, MomentumChangesByTheImpulseOfGravityAndTractionsOnly) {
  constexpr int D = TypeParam::value;
  for (const bool mixed : {false, true}) {
    Body<D> body = make_body(this->make_mesh(), this->make_elastic());
    fill(body, 1800.0, 0, [](const Vector<D>& x) { return (x - Vector<D>::Constant(0.75)).norm() < 0.5; });
    body.gravity[1] = -2;
    body.tractions.assign(body.mesh.nodes.size(), Vector<D>::Zero());
    randomise_velocity(body, 0.4);
    const Vector<D> before = sum_momentum(body);
    Vector<D> impulse = Vector<D>::Zero();
    double mass = 0;
    for (const Point<D>& point : body.points) mass += point.mass;
    const double dt = 5e-4;
    const int loaded = node_of(body.mesh, body.points[body.points.size() / 2].element, 0);
    double stress = 0;
    for (int n = 0; n < 100; ++n) {
      at(body.tractions, loaded)[0] = 20.0 * n;
      step(body, {.time_step = dt, .mixed = mixed, .smoothing = Smoothing::strain});
      impulse += dt * (mass * body.gravity + at(body.tractions, loaded));
      for (const Point<D>& point : body.points) stress = std::max(stress, point.sigma.norm());
    }
    EXPECT_EQ(body.left, 0);
    EXPECT_GT(stress, 1e3);  // forces inside the body did act
    EXPECT_LT((sum_momentum(body) - before - impulse).norm(), 1e-10 * (before.norm() + impulse.norm()));
  }
}

TYPED_TEST(ReferenceStep, MassScalingSlowsTheResponseByItsFactor) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>&) { return true; });
  body.gravity[1] = -3;
  step(body, {.time_step = 1e-4, .mass_scaling = 4});
  for (const Point<D>& point : body.points) EXPECT_NEAR(point.v[1], -3 * 1e-4 / 4, 1e-15);
}

TYPED_TEST(ReferenceStep, UniformStressIsInEquilibriumWithItsTractions) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>&) { return true; });
  Tensor sigma;
  sigma << -3e3, 1e3, 0, 1e3, -5e3, 0, 0, 0, -2e3;
  if (D == 3) sigma(0, 2) = sigma(2, 0) = -7e2;
  for (Point<D>& point : body.points) point.sigma = sigma;
  // Traction σ·n on each boundary side, a D-th of it to each of the side's nodes. The area vector points away from the
  // node opposite.
  body.tractions.assign(body.mesh.nodes.size(), Vector<D>::Zero());
  for (int e = 0; e < body.mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      if (at(at(body.mesh.neighbours, e), k) >= 0) continue;
      std::vector<int> nodes;
      for (int i = 0; i <= D; ++i)
        if (i != k) nodes.push_back(node_of(body.mesh, e, i));
      const auto position = [&](int node) {
        Vector3 x = Vector3::Zero();
        for (int d = 0; d < D; ++d) x[d] = at(at(body.mesh.nodes, node), d);
        return x;
      };
      const Vector3 first = position(nodes[1]) - position(nodes[0]);
      const Vector3 second = D == 3 ? Vector3((position(nodes.back()) - position(nodes[0])) / 2) : Vector3::UnitZ();
      Vector3 area = first.cross(second);
      if (area.dot(position(node_of(body.mesh, e, k)) - position(nodes[0])) > 0) area = -area;
      for (int node : nodes) at(body.tractions, node) += (sigma * area).template head<D>() / D;
    }
  const std::vector<Point<D>> start = body.points;
  step(body, {.time_step = 1e-3});
  for (const Cell& cell : body.cells) EXPECT_TRUE(cell.full);
  for (std::size_t p = 0; p < start.size(); ++p) {
    EXPECT_LT(body.points[p].v.norm(), 1e-12);
    EXPECT_LT((body.points[p].sigma - sigma).norm(), 1e-9);
  }
}

TYPED_TEST(ReferenceStep, HeavySoilUnderItsOwnLinearStressDoesNotMove) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>&) { return true; });
  fix_box(body, this->box_size());
  body.gravity[1] = -9.81;
  set_k0_stress(body, {0, 1.5, 1, 1.5}, 9.81, 0.4);
  for (int n = 0; n < 20; ++n) step(body, {.time_step = 5e-4, .smoothing = Smoothing::stable});
  double stress = 0;
  for (const Point<D>& point : body.points) {
    EXPECT_LT(point.v.norm(), 1e-11);
    stress = std::max(stress, -point.sigma(1, 1));
  }
  EXPECT_GT(stress, 1800 * 9.81 * 1.2);
}

TYPED_TEST(ReferenceStep, AffineVelocityGivesItsGradientWithAndWithoutSmoothing) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>& x) { return x[1] < 1; });
  Eigen::Matrix<double, D, D> l;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) l(i, j) = 0.3 * i - 0.7 * j + 0.2;
  for (const Smoothing smoothing : {Smoothing::none, Smoothing::strain}) {
    const Settings settings{.time_step = 0.01, .smoothing = smoothing};
    classify_elements(body, settings);
    map_points_to_nodes(body);
    for (std::size_t i = 0; i < body.nodes.size(); ++i)
      body.nodes[i].velocity = l * Eigen::Map<const Vector<D>>(body.mesh.nodes[i].data());
    compute_strain_increments(body, settings);
    const Eigen::Matrix<double, D, D> expected = 0.005 * (l + l.transpose());
    for (const Cell& cell : body.cells) {
      if (!cell.is_active()) continue;
      const Tensor& strain = cell.strain_increment;
      EXPECT_LT((strain.template topLeftCorner<D, D>() - expected).norm(), 1e-14);
      EXPECT_NEAR(strain.trace(), expected.trace(), 1e-14);
    }
  }
}

TYPED_TEST(ReferenceStep, PointsAreFoundInTheElementThatContainsThem) {
  constexpr int D = TypeParam::value;
  const mesh::Mesh<D> mesh = this->make_mesh();
  const auto size = this->box_size();
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    Point<D> point;
    for (int d = 0; d < D; ++d)
      point.x[d] = at(size, d) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    int containing = -1;
    for (int e = 0; e < mesh.element_count(); ++e)
      if (shape_functions(mesh, e, point.x).minCoeff() > 1e-9) containing = e;
    if (containing < 0) continue;  // on a side: either element is right
    point.element = trial % mesh.element_count();
    ASSERT_TRUE(relocate(mesh, point));
    EXPECT_EQ(point.element, containing);
  }
}

TYPED_TEST(ReferenceStep, PointsThatLeaveAreCountedAndRoundOffIsNot) {
  constexpr int D = TypeParam::value;
  Body<D> body = make_body(this->make_mesh(), this->make_elastic());
  fill(body, 1800.0, 0, [](const Vector<D>&) { return true; });
  const std::size_t count = body.points.size();
  body.points[3].x[0] = 2 + 1e-6;
  body.points[4].x[0] = 2 + 1e-13;
  relocate_points(body);
  EXPECT_EQ(body.left, 1);
  ASSERT_EQ(body.points.size(), count - 1);
  EXPECT_EQ(body.points[3].id, 4);
  EXPECT_LE(body.points[3].x[0], 2);
}

template <int D>
void expect_admissible_collapse(double duration) {
  Body<D> body = make_slope<D>();
  const Material& soil = body.materials[0];
  const double altitude = *std::min_element(body.mesh.altitudes.begin(), body.mesh.altitudes.end());
  const double constrained = soil.young_modulus * 0.7 / (1.3 * 0.4);
  const double dt = 0.6 * altitude / std::sqrt(constrained / 1700);
  const auto count = body.points.size();
  const auto energy = [&] {
    double sum = 0;
    for (const Point<D>& point : body.points) sum += point.mass * (9.81 * point.x[1] + point.v.squaredNorm() / 2);
    return sum;
  };
  const double energy_before = energy();
  double largest_move = 0;
  const std::vector<Point<D>> start = body.points;
  for (double t = 0; t < duration; t += dt)
    step(body, {.time_step = dt, .damping = 0.02, .smoothing = Smoothing::strain});
  ASSERT_EQ(body.points.size(), count);
  double plastic = 0, partial = 0;
  const double s = std::sin(soil.friction_angle), strength = 2 * soil.cohesion * std::cos(soil.friction_angle);
  for (std::size_t p = 0; p < count; ++p) {
    const Vector3 sigma = Eigen::SelfAdjointEigenSolver<Tensor>(body.points[p].sigma).eigenvalues();
    EXPECT_LT(sigma[2] - sigma[0] + (sigma[2] + sigma[0]) * s - strength, 1e-5);
    EXPECT_LT(sigma[2], soil.tensile_strength + 1e-5);
    plastic = std::max(plastic, body.points[p].plastic_strain);
    largest_move = std::max(largest_move, (body.points[p].x - start[p].x).norm());
  }
  for (const Cell& cell : body.cells) partial += cell.is_active() && !cell.full;
  EXPECT_GT(largest_move, 0.3);
  EXPECT_GT(plastic, 0.1);
  EXPECT_GT(partial, 5);
  EXPECT_LT(energy(), energy_before);  // only the elastic energy of the start could be added, and it is small
}

TEST(ReferenceSlope, CollapseInPlaneStrainStaysAdmissibleAndLosesEnergy) {
  expect_admissible_collapse<2>(0.8);
}
TEST(ReferenceSlope, CollapseInThreeDimensionsStaysAdmissibleAndLosesEnergy) {
  expect_admissible_collapse<3>(0.8);
}

}  // namespace
}  // namespace talus::reference
