// SPDX-License-Identifier: MIT
// Bodies without supports: free fall, momentum, and the rotation of stressed blocks.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "mpm/solver/step.hpp"
#include "support/draw.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

using support::Mode;

template <class Dimension>
class EngineMotion : public ::testing::Test {};

template <int D>
Vec<D> fill_vec(double value) {
  Vec<D> v;
  v.fill(value);
  return v;
}

/// A ball of soil of radius `radius` in the middle of a box of 2 m.
template <int D>
mpm::Body<D> make_ball(double radius, const material::Law& law, const support::Start<D>& start) {
  std::array<int, D> cells;
  cells.fill(D == 2 ? 12 : 7);
  return support::fill_body<D>(
      support::make_mesh<D>(cells, fill_vec<D>(2)), {{law, 1800}}, D == 2 ? 3 : 4,
      [&](const Vec<D>& x) {
        double r2 = 0;
        for (double c : x) r2 += (c - 1) * (c - 1);
        return r2 < radius * radius ? 0 : -1;
      },
      start, 3);
}

using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EngineMotion, Dimensions);

const material::LinearElastic soft = material::LinearElastic::from_young(1e6, 0.3);

TYPED_TEST(EngineMotion, FreeFallFollowsTheParabolaOfTheScheme) {
  constexpr int D = TypeParam::value;
  for (const Mode& mode : support::all_modes()) {
    Vec<D> v0 = fill_vec<D>(0.2);
    v0[1] = 1.5;
    mpm::Body<D> body = make_ball<D>(0.5, soft, [&](mpm::InitialPoint<D>& p, const Vec<D>&) { p.velocity = v0; });
    std::vector<Vec<D>> start;
    for (int id = 0; id < body.points.size(); ++id) start.push_back(mpm::view_point(body, id).position);
    const std::vector<int> elements = body.points.element;
    mpm::StepOptions<D> o;
    o.dt = 2e-3;
    o.gravity[1] = -9.81;
    o.mixed = mode.mixed;
    o.smoothing = mode.smoothing;
    mpm::gather_nodal_sums(body, o);
    const int steps = 150;
    support::run_steps(body, o, steps);
    ASSERT_TRUE(body.lost.empty());
    support::for_each_point(body, [&](int id, const mpm::PointView<D>& p) {
      for (std::size_t d = 0; d < D; ++d) {
        // x_N = x_0 + Σ Δt (v_0 + nΔt g)
        const double g = o.gravity[d], x = start[static_cast<std::size_t>(id)][d] + steps * o.dt * v0[d] +
                                           o.dt * o.dt * steps * (steps + 1) / 2 * g;
        EXPECT_NEAR(p.velocity[d], v0[d] + steps * o.dt * g, 1e-11) << mode.name;
        EXPECT_NEAR(p.position[d], x, 1e-11) << mode.name;
      }
      for (double s : p.stress) EXPECT_NEAR(s, 0, 1e-4) << mode.name;  // round-off of 1e6 Pa
    });
    EXPECT_NE(elements, body.points.element) << "points must change their elements to test anything";
  }
}

TYPED_TEST(EngineMotion, LinearMomentumChangesByTheImpulseOfGravityAlone) {
  constexpr int D = TypeParam::value;
  for (const Mode& mode : support::all_modes()) {
    support::Draw draw(3);
    mpm::Body<D> body = make_ball<D>(0.7, soft, [&](mpm::InitialPoint<D>& p, const Vec<D>&) {
      for (double& v : p.velocity) v = draw(-1, 1);
    });
    mpm::StepOptions<D> o;
    o.dt = 0.5 * mpm::find_critical_step(body, 1).dt;
    o.gravity[1] = -2;
    o.mixed = mode.mixed;
    o.smoothing = mode.smoothing;
    mpm::gather_nodal_sums(body, o);
    const auto before = mpm::sum_points(body, {});
    const int steps = 150;
    support::run_steps(body, o, steps);
    ASSERT_TRUE(body.lost.empty());
    const auto after = mpm::sum_points(body, {});
    double stress = 0;
    support::for_each_point(body,
                            [&](int, const mpm::PointView<D>& p) { stress = std::max(stress, std::abs(p.stress[0])); });
    EXPECT_GT(stress, 1e3) << "forces inside the body must act";
    EXPECT_DOUBLE_EQ(after.mass, before.mass);
    for (std::size_t d = 0; d < D; ++d) {
      EXPECT_NEAR(after.momentum[d] - before.momentum[d], after.mass * steps * o.dt * o.gravity[d], 1e-11 * after.mass)
          << mode.name;
    }
  }
}

/// Angular momentum of the points about `c`, the z component [kg m²/s].
template <int D>
double sum_spin(const mpm::Body<D>& body, const Vec<D>& c) {
  double sum = 0;
  support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
    sum += p.mass * ((p.position[0] - c[0]) * p.velocity[1] - (p.position[1] - c[1]) * p.velocity[0]);
  });
  return sum;
}

/// A block that spins about its middle carries the exact stress of plane elasticity without Poisson's effect:
/// σ_xx = ½ρω²(a²-x²), σ_yy = ½ρω²(b²-y²) on the axes of the block, free of traction on all sides.
struct Spin {
  double turns = 1, omega = 10, density = 1000, young_modulus = 1e7;  ///< [-], [rad/s], [kg/m³], [Pa]
  double a = 0.8, b = 0.4;                                            ///< half lengths [m]
  bool objective = true;
  double courant = 0.5;
};

/// Relative changes after the turns. `shear`: 2ε_xy of the block on its own axes.
struct Changes {
  double energy = 0, spin = 0, shear = 0;
};

/// FᵀF of the affine motion that fits the points' positions now and at the start best.
inline Eigen::Matrix2d fit_stretch(const std::vector<Eigen::Vector2d>& start, const std::vector<Eigen::Vector2d>& now) {
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero(), moment = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < start.size(); ++i) {
    across += now[i] * start[i].transpose();
    moment += start[i] * start[i].transpose();
  }
  const Eigen::Matrix2d f = across * moment.inverse();
  return f.transpose() * f;
}

/// In-plane positions of the points, from the middle of the box.
template <int D>
std::vector<Eigen::Vector2d> list_places(const mpm::Body<D>& body) {
  std::vector<Eigen::Vector2d> places;
  support::for_each_point(
      body, [&](int, const mpm::PointView<D>& p) { places.emplace_back(p.position[0] - 1, p.position[1] - 1); });
  return places;
}

template <int D>
Changes spin_block(const Spin& s, int cells_across) {
  std::array<int, D> cells;
  Vec<D> size;
  cells[0] = cells[1] = cells_across;
  size[0] = size[1] = 2;
  if constexpr (D == 3) {
    cells[2] = 1;
    size[2] = 2.0 / cells_across;
  }
  const auto stress = [&](double half, double x) {
    return 0.5 * s.density * s.omega * s.omega * (half * half - x * x);
  };
  mpm::Body<D> body = support::fill_body<D>(
      support::make_mesh<D>(cells, size, 0), {{material::LinearElastic::from_young(s.young_modulus, 0), s.density}},
      D == 2 ? 6 : 4, [&](const Vec<D>& x) { return std::abs(x[0] - 1) < s.a && std::abs(x[1] - 1) < s.b ? 0 : -1; },
      [&](mpm::InitialPoint<D>& p, const Vec<D>& x) {
        p.velocity[0] = -s.omega * (x[1] - 1);
        p.velocity[1] = s.omega * (x[0] - 1);
        p.stress[0] = stress(s.a, x[0] - 1);
        p.stress[1] = stress(s.b, x[1] - 1);
      });
  if constexpr (D == 3) support::fix_nodes<3>(body, 2, [](const Vec<3>&) { return true; });
  mpm::StepOptions<D> o;
  o.mixed = true;
  o.objective = s.objective;
  o.dt = s.courant * mpm::find_critical_step(body, 1).dt;
  mpm::gather_nodal_sums(body, o);
  const auto before = mpm::sum_points(body, {});
  Vec<D> middle{};
  middle[0] = middle[1] = 1;
  const double spin = sum_spin<D>(body, middle);
  const auto places = list_places(body);
  const int steps = static_cast<int>(std::round(2 * std::numbers::pi * s.turns / s.omega / o.dt));
  support::run_steps(body, o, steps);
  EXPECT_TRUE(body.lost.empty());
  const auto after = mpm::sum_points(body, {});
  return {(after.kinetic + after.elastic) / (before.kinetic + before.elastic) - 1, sum_spin<D>(body, middle) / spin - 1,
          fit_stretch(places, list_places(body))(0, 1)};
}

TEST(EngineSpin, EnergyAndSpinOfAFreeBlockAreKeptToTheErrorOfTheMesh) {
  // The mapping between points and nodes costs energy and spin; both losses shrink with the mesh.
  const Changes coarse = spin_block<2>({}, 20), fine = spin_block<2>({}, 40);
  EXPECT_LT(std::abs(coarse.energy), 0.06);
  EXPECT_LT(std::abs(fine.energy), 0.5 * std::abs(coarse.energy));
  EXPECT_LT(std::abs(coarse.spin), 0.025);
  EXPECT_LT(std::abs(fine.spin), 0.4 * std::abs(coarse.spin));
}

TEST(EngineSpin, OnlyTheObjectiveRateKeepsTheShapeOfASpinningBlock) {
  // With stresses that do not turn, the block must shear at the rate (Ωσ - σΩ)/E on its own axes to carry the
  // centrifugal force: 2ε_xy = 2·2π(σ_axial - σ_across)/E in one turn, about 7 % here.
  const Spin turn{.young_modulus = 3e6};
  Spin stale = turn;
  stale.objective = false;
  EXPECT_LT(std::abs(spin_block<2>(turn, 30).shear), 0.003);
  EXPECT_GT(std::abs(spin_block<2>(stale, 30).shear), 0.05);
}

/// Every node is made to turn about `axis` [rad/s], so that a point sees nothing but rotation.
template <int D>
void turn_all_nodes(mpm::Body<D>& body, const Eigen::Vector3d& axis) {
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t d = 0; d < D; ++d) x[static_cast<Eigen::Index>(d)] = body.mesh().nodes[i][d] - 1;
    const Eigen::Vector3d v = axis.cross(x);
    Vec<D> velocity{};
    for (std::size_t d = 0; d < D; ++d) velocity[d] = v[static_cast<Eigen::Index>(d)];
    support::move_node<D>(body, i, velocity);
  }
}

template <int D>
void expect_stress_to_turn(bool mixed, bool objective, Eigen::Vector3d axis) {
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  Eigen::Matrix3d start;
  start << -8e3, 1e3, D == 3 ? 2e3 : 0, 1e3, -3e3, D == 3 ? -1.5e3 : 0, D == 3 ? 2e3 : 0, D == 3 ? -1.5e3 : 0, -5e3;
  mpm::Body<D> body =
      make_ball<D>(0.45, material::LinearElastic::from_young(1e6, 0.3), [&](mpm::InitialPoint<D>& p, const Vec<D>& x) {
        Eigen::Vector3d r = Eigen::Vector3d::Zero();
        for (std::size_t d = 0; d < D; ++d) r[static_cast<Eigen::Index>(d)] = x[d] - 1;
        const Eigen::Vector3d v = axis.cross(r);
        for (std::size_t d = 0; d < D; ++d) p.velocity[d] = v[static_cast<Eigen::Index>(d)];
        for (std::size_t i = 0; i < p.stress.size(); ++i) p.stress[i] = start(row[i], column[i]);
      });
  turn_all_nodes<D>(body, axis);
  mpm::StepOptions<D> o;
  o.mixed = mixed;
  o.objective = objective;
  const int steps = 1500;
  const double turns = 1.1, omega = axis.norm();
  o.dt = 2 * std::numbers::pi * turns / omega / steps;
  mpm::gather_nodal_sums(body, o);
  support::run_steps(body, o, steps);
  ASSERT_TRUE(body.lost.empty());
  // Hughes and Winget turn by 2 atan(ωΔt/2) each step.
  const double angle = objective ? steps * 2 * std::atan(omega * o.dt / 2) : 0;
  EXPECT_NEAR(steps * 2 * std::atan(omega * o.dt / 2), 2 * std::numbers::pi * turns, 2e-5);
  const Eigen::Matrix3d q = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  const Eigen::Matrix3d expected = q * start * q.transpose();
  support::for_each_point(body, [&](int id, const mpm::PointView<D>& p) {
    for (std::size_t i = 0; i < p.stress.size(); ++i) {
      ASSERT_NEAR(p.stress[i], expected(row[i], column[i]), 1e-10 * start.norm()) << "point " << id;
    }
  });
}

TEST(EngineSpin, StressesTurnWithAnImposedRotationExactly) {
  for (const bool mixed : {false, true}) {
    expect_stress_to_turn<2>(mixed, true, {0, 0, 3});
    expect_stress_to_turn<2>(mixed, true, {0, 0, -5});
    expect_stress_to_turn<3>(mixed, true, {1, -2, 1.5});
    expect_stress_to_turn<3>(mixed, true, {0, 0, 2});
  }
}

TEST(EngineSpin, StressesStayBehindWithoutTheObjectiveRate) {
  expect_stress_to_turn<2>(true, false, {0, 0, 3});
  expect_stress_to_turn<3>(true, false, {1, -2, 1.5});
}

}  // namespace
}  // namespace talus
