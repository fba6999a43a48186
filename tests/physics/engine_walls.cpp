// SPDX-License-Identifier: MIT
// Walls: sliding with Coulomb friction, rollers on an inclined plane, and moving boundaries.

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "support/box_case.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

constexpr double gravity = 9.81, density = 2000;

template <class Dimension>
class EngineWalls : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EngineWalls, Dimensions);

/// A block 0.4 m long and 0.2 m high on the floor of a trough. Gravity is tilted by θ instead of the floor; the block
/// carries the normal stress of its weight from the start.
template <int D>
mpm::Body<D> make_block_on_floor(double theta) {
  std::array<int, D> cells;
  Vec<D> size;
  cells[0] = 24, size[0] = 2.4;
  cells[1] = 4, size[1] = 0.4;
  if constexpr (D == 3) cells[2] = 2, size[2] = 0.2;
  mpm::Body<D> body = support::fill_body<D>(
      support::make_mesh<D>(cells, size, 0), {{material::LinearElastic::from_young(5e6, 0), density}}, D == 2 ? 3 : 4,
      [](const Vec<D>& x) { return x[0] > 0.2 && x[0] < 0.6 && x[1] < 0.2 ? 0 : -1; },
      [&](mpm::InitialPoint<D>& p, const Vec<D>& x) {
        p.stress[1] = -density * gravity * std::cos(theta) * (0.2 - x[1]);
      });
  if constexpr (D == 3) {
    support::fix_nodes<3>(body, 2, [](const Vec<3>& x) { return x[2] < 1e-9 || x[2] > 0.2 - 1e-9; });
  }
  return body;
}

/// Runs `duration` seconds; returns the change of the centre of mass's velocity along the floor [m/s].
template <int D>
double slide(mpm::Body<D>& body, double theta, double duration, double damping = 0) {
  mpm::StepOptions<D> o;
  o.mixed = true;
  o.damping = damping;
  o.gravity[0] = gravity * std::sin(theta);
  o.gravity[1] = -gravity * std::cos(theta);
  const int steps = static_cast<int>(std::ceil(duration / (0.6 * mpm::find_critical_step(body, 1).dt)));
  o.dt = duration / steps;
  mpm::gather_nodal_sums(body, o);
  support::run_steps(body, o, steps);
  const auto t = mpm::sum_points(body, {});
  return t.momentum[0] / t.mass;
}

TYPED_TEST(EngineWalls, BlockSlidesWithCoulombsAcceleration) {
  constexpr int D = TypeParam::value;
  const double theta = 0.5, duration = 0.5;
  for (const double mu : {0.0, 0.1, 0.25, 0.4}) {
    mpm::Body<D> body = make_block_on_floor<D>(theta);
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
      if (body.mesh().nodes[i][1] > 1e-9) continue;
      auto& c = support::get_constraint(body, i);
      c.has_wall = true;
      c.wall_normal[1] = -1;
      c.friction = mu;
    }
    const double a = slide(body, theta, duration) / duration;
    EXPECT_NEAR(a, gravity * (std::sin(theta) - mu * std::cos(theta)), 0.01 * gravity) << "mu = " << mu;
  }
}

TYPED_TEST(EngineWalls, BlockSticksBelowTheAngleOfFriction) {
  constexpr int D = TypeParam::value;
  const double theta = 0.4;
  mpm::Body<D> body = make_block_on_floor<D>(theta);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (body.mesh().nodes[i][1] > 1e-9) continue;
    auto& c = support::get_constraint(body, i);
    c.has_wall = true;
    c.wall_normal[1] = -1;
    c.friction = 2 * std::tan(theta);
  }
  // Free sliding would reach gsinθ = 3.8 m/s and 1.9 m. Damping removes the rocking from the suddenly applied gravity.
  slide(body, theta, 1, 0.2);
  const double there = mpm::sum_points(body, {}).centre[0];
  EXPECT_LT(std::abs(slide(body, theta, 1, 0.2)), 1e-3);
  EXPECT_LT(std::abs(mpm::sum_points(body, {}).centre[0] - there), 1e-4) << "the block must not creep";
  EXPECT_LT(mpm::find_largest_displacement(body).value, 0.01);
}

TEST(EngineWallsPlane, StickingBlockComesToRest) {
  // The wall's reaction, and its friction up to μ times as much, is no unbalanced force.
  const double theta = 0.3;
  mpm::Body<2> body = make_block_on_floor<2>(theta);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (body.mesh().nodes[i][1] > 1e-9) continue;
    auto& c = support::get_constraint(body, i);
    c.has_wall = true;
    c.wall_normal[1] = -1;
    c.friction = 0.6;
  }
  run::StagePlan<2> plan;
  plan.name = "lying";
  plan.duration = 20;
  plan.until_rest = true;
  plan.step.damping = 0.7;
  plan.gravity = {gravity * std::sin(theta), -gravity * std::cos(theta)};
  plan.soil_height = 0.2;
  run::StageState state;
  EXPECT_EQ(run::run_stage(body, plan, state), results::StageEnd::rest);
  EXPECT_LT(body.time, 20);
}

TEST(EngineWallsPlane, BlockOnAFrictionalWallMayLeaveIt) {
  mpm::Body<2> body = make_block_on_floor<2>(0);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (body.mesh().nodes[i][1] > 1e-9) continue;
    auto& c = support::get_constraint(body, i);
    c.has_wall = true;
    c.wall_normal[1] = -1;
    c.friction = 0.5;
  }
  mpm::StepOptions<2> o;
  o.dt = 0.5 * mpm::find_critical_step(body, 1).dt;
  o.gravity[1] = 5;  // upwards
  const double before = mpm::sum_points(body, {}).centre[1];
  mpm::gather_nodal_sums(body, o);
  const int steps = static_cast<int>(0.15 / o.dt);
  support::run_steps(body, o, steps);
  // besides gravity only the wall's push that is released with the stress: upwards
  EXPECT_GE(mpm::sum_points(body, {}).centre[1] - before, 0.5 * 5 * 0.15 * 0.15 * 0.98);
}

TEST(EngineWallsPlane, RollersOnAnInclinedPlaneLetABlockSlideWithTheComponentOfGravity) {
  const double theta = 0.6;
  auto mesh = support::make_box_mesh<2>(
      {24, 4}, {2.4, 0.4}, {"soil"}, [](const Vec<2>& x) { return x[0] > 1.8 && x[0] < 2.2 && x[1] < 0.2 ? 0 : -1; },
      0);
  for (auto& x : mesh.nodes)
    x = {x[0] * std::cos(theta) - x[1] * std::sin(theta), x[0] * std::sin(theta) + x[1] * std::cos(theta)};
  mesh::finish(mesh, mesh::Order::as_given);
  for (const bool by_plane : {true, false})  // a stated plane, or the normals of the side
    for (const double damping : {0.0, 0.3}) {
      input::Case data;
      data.materials["soil"] = support::make_elastic(5e6, 0.3, density);
      data.regions["soil"] = "soil";
      data.boundaries = {support::make_boundary("bottom", by_plane ? input::Fix::plane : input::Fix::normal)};
      data.boundaries[0].normal = {std::sin(theta), -std::cos(theta), 0};
      mpm::Body<2> body = run::prepare<2>(data, mesh);
      const auto plan = support::make_stage(data, body, 0.5, {.damping = damping});
      EXPECT_EQ(support::run_plan(body, plan), results::StageEnd::time);
      ASSERT_TRUE(body.lost.empty());
      const auto t = mpm::sum_points(body, {});
      // Rollers push along the normal only: the momentum along the slope is that of gravity, whatever the block does.
      const double along = (-std::cos(theta) * t.momentum[0] - std::sin(theta) * t.momentum[1]) / t.mass;
      // Damping does not act on the reactions of the rollers; otherwise they would cause friction. The block bounces at
      // first, and damping acts by component: 4 %.
      EXPECT_NEAR(along, (1 - damping) * gravity * std::sin(theta) * 0.5, damping > 0 ? 0.1 : 1e-9);
      const double off = std::abs(-std::sin(theta) * t.momentum[0] + std::cos(theta) * t.momentum[1]) / t.mass;
      EXPECT_LT(off, 0.05) << "the block stays on the plane";
    }
}

TYPED_TEST(EngineWalls, PrescribedVelocityFollowsItsTable) {
  constexpr int D = TypeParam::value;
  std::array<int, D> cells;
  Vec<D> size;
  cells.fill(1);
  size.fill(1);
  // Every node is on the boundary, so the soil has the prescribed motion.
  auto mesh = support::make_box_mesh<D>(cells, size, {"soil"}, [](const Vec<D>&) { return 0; });
  input::Case data = support::make_box_case<D>(support::make_elastic());
  data.boundaries.clear();
  for (const auto& [name, sides] : mesh.sides) {
    data.boundaries.push_back(support::make_boundary(name, input::Fix::velocity));
    data.boundaries.back().velocity = {0.02, -0.01, 0.005};
    data.boundaries.back().factor = {{0.1, 0.3, 0.4}, {0, 1, -1}};
  }
  data.gravity.acceleration = 0;
  mpm::Body<D> body = run::prepare<D>(data, mesh);
  const auto plan = support::make_stage(data, body, 0.5, {});
  EXPECT_EQ(support::run_plan(body, plan), results::StageEnd::time);
  // ∫ factor dt = 0.1 on the way up, 0 in the turn, -0.1 after it; the step adds O(Δt)
  const double dt = 0.9 * mpm::find_critical_step(body, 1).dt;
  support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
    EXPECT_NEAR(p.displacement[0], 0.02 * (0.1 - 0.1), 0.02 * 2 * dt);
    EXPECT_NEAR(p.velocity[0], 0.02 * -1, 1e-12);
    EXPECT_NEAR(p.velocity[1], -0.01 * -1, 1e-12);
  });
  // half way up: at t = 0.3 the displacement is v·0.1
  mpm::Body<D> half = run::prepare<D>(data, mesh);
  EXPECT_EQ(support::run_plan(half, support::make_stage(data, half, 0.3, {})), results::StageEnd::time);
  support::for_each_point(half, [&](int, const mpm::PointView<D>& p) {
    EXPECT_NEAR(p.displacement[0], 0.02 * 0.1, 0.02 * 2 * dt);
    EXPECT_NEAR(p.displacement[1], -0.01 * 0.1, 0.01 * 2 * dt);
    if constexpr (D == 3) {
      EXPECT_NEAR(p.displacement[2], 0.005 * 0.1, 0.005 * 2 * dt);
    }
  });
}

/// A smooth plate on the given side; in two seconds it goes the way of one with `velocity` [m/s].
input::Boundary make_plate(const std::string& on, const std::array<double, 3>& velocity) {
  input::Boundary plate = support::make_boundary(on, input::Fix::velocity);
  plate.smooth = true;
  plate.velocity = velocity;
  plate.factor = {{0, 1, 2}, {0, 1, 0}};
  return plate;
}

template <int D>
struct PressedBlock {
  static constexpr double young = 1e6, poisson = 0.3;
  mesh::Mesh<D> mesh;
  input::Case data = support::make_box_case<D>(support::make_elastic(young, poisson, 1800));

  PressedBlock() {
    std::array<int, D> cells;
    Vec<D> size;
    cells.fill(D == 2 ? 4 : 2);
    size.fill(1);
    mesh = support::make_box_mesh<D>(cells, size, {"soil"}, [](const Vec<D>&) { return 0; });
    data.gravity.acceleration = 0;
    std::erase_if(data.boundaries, [](const input::Boundary& b) { return b.on == "right" || b.on == "back"; });
  }
  /// Mean stresses [Pa] along the axes after the plates have come to rest; the stress is uniform.
  std::array<double, 3> press() const {
    mpm::Body<D> body = run::prepare<D>(data, mesh);
    EXPECT_EQ(support::run_plan(body, support::make_stage(data, body, 4, {.damping = 0.5})), results::StageEnd::time);
    std::array<double, 3> mean{};
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      for (std::size_t i = 0; i < 3; ++i) mean[i] += p.stress[i] / body.points.size();
    });
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(p.stress[i], mean[i], 0.01);
      for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(p.stress[i], 0, 0.01);
    });
    return mean;
  }
};

/// σ = E ε, in plane strain E ε/(1 − ν²): the block is free to become wider.
TYPED_TEST(EngineWalls, SmoothPlateHoldsNothingAlongIt) {
  constexpr int D = TypeParam::value;
  PressedBlock<D> block;
  const double strain = -1e-5;
  block.data.boundaries.push_back(make_plate("top", {0.3, strain, 0}));
  const auto stress = block.press();
  const double exact = block.young * strain / (D == 2 ? 1 - block.poisson * block.poisson : 1);
  EXPECT_NEAR(stress[1], exact, 2e-4 * std::abs(exact));
  EXPECT_NEAR(stress[0], 0, 2e-4 * std::abs(exact));
}

/// The node where two plates meet moves with both.
TYPED_TEST(EngineWalls, TwoSmoothPlatesPressFromTwoSides) {
  constexpr int D = TypeParam::value;
  PressedBlock<D> block;
  const double x = -1e-5, y = -2e-5, nu = block.poisson;
  block.data.boundaries.push_back(make_plate("top", {0, y, 0}));
  block.data.boundaries.push_back(make_plate("right", {x, 0, 0}));
  const auto stress = block.press();
  const double fraction = D == 2 ? nu / (1 - nu) : nu, modulus = block.young / (D == 2 ? 1 - nu * nu : 1);
  const double exact = modulus * (y + fraction * x) / (1 - fraction * fraction);
  EXPECT_NEAR(stress[1], exact, 2e-4 * std::abs(exact));
  EXPECT_NEAR(stress[0], modulus * (x + fraction * y) / (1 - fraction * fraction), 2e-4 * std::abs(exact));
}

/// A smooth plate moves down, and the soil beside it slides along a fixed plane.
TEST(EnginePlates, PlateThatMeetsAnInclinedPlaneMovesAlongIt) {
  PressedBlock<2> block;
  input::Boundary plane = support::make_boundary("right", input::Fix::plane);
  plane.normal = {0.6, 0.8, 0};
  block.data.boundaries.push_back(plane);
  block.data.boundaries.push_back(make_plate("top", {0, -0.01, 0}));
  const mpm::Body<2> body = run::prepare<2>(block.data, block.mesh);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (body.mesh().nodes[i][0] < 1 - 1e-9 || body.mesh().nodes[i][1] < 1 - 1e-9) continue;
    const auto& c = body.conditions.constraints.at(static_cast<std::size_t>(body.conditions.constraint_of_node[i]));
    const Vec<2> v = mpm::constrain_velocity(body.conditions, c, {1, 1}, 1);
    EXPECT_NEAR(v[1], -0.01, 1e-15);
    EXPECT_NEAR(0.6 * v[0] + 0.8 * v[1], 0, 1e-15);
  }
}

TEST(EnginePlates, PlatesThatMeetNeedOneFactor) {
  PressedBlock<2> block;
  block.data.boundaries.push_back(make_plate("top", {0, -0.01, 0}));
  block.data.boundaries.push_back(make_plate("right", {-0.01, 0, 0}));
  block.data.boundaries.back().factor = {};
  try {
    run::prepare<2>(block.data, block.mesh);
    FAIL() << "the factors differ";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(e.what()).find("'right' meets another one that moves"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace talus
