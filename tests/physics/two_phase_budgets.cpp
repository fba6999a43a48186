// SPDX-License-Identifier: MIT
// Budgets of the plain two-velocity step: momentum and water close to round-off, and the work of the pressures on both
// phases equals that of the storage of the water.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "physics/gravity.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

/// A half-filled box of two kinds of unsaturated soil with random motion of both phases.
template <int D>
WetBody<D> make_disturbed() {
  std::array<int, D> cells{};
  cells.fill(D == 2 ? 8 : 4);
  WetBody<D> body = make_wet_body(make_box<D>(cells, cube<D>(1.0)), make_retaining_soil());
  body.soils.push_back(make_table_soil(1e-11));
  for (Soil& soil : body.soils) soil.water.bulk_modulus = 2e6;
  const auto suction = [](const Vector<D>& x) { return 3e4 * (x[1] - 0.4); };
  fill_wet(
      body, 0.4, 0, [](const Vector<D>& x) { return x[1] < 0.6 && x[1] > 0.3 && x[0] < 0.8; }, suction);
  fill_wet(
      body, 0.3, 1, [](const Vector<D>& x) { return x[1] < 0.3; }, suction);
  std::mt19937 random(5);
  const auto draw = [&] {
    return 0.1 * (2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1);
  };
  for (WetPoint<D>& point : body.points)
    for (int d = 0; d < D; ++d) point.v[d] = draw(), point.w[d] = draw();
  body.gravity[1] = -g;
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::rain, .rain = -1e-3 * Vector<D>::Unit(1)});
  return body;
}

template <int D>
void expect_budgets(const WetSettings& settings) {
  WetBody<D> body = make_disturbed<D>();
  double begin = 0, now = 0;
  for (const WetPoint<D>& point : body.points) begin += point.water_mass;
  for (int n = 0; n < 100; ++n) {
    classify_wet_elements(body, settings);
    average_wet_state(body);
    Vector<D> before = Vector<D>::Zero(), after = before;
    double mass = 0;
    std::vector<double> water;
    for (const WetPoint<D>& point : body.points) {
      before += point.mass * point.v + point.water_mass * point.w;
      mass += point.mass + point.water_mass;
      water.push_back(point.water_mass);
    }
    step(body, settings);
    ASSERT_EQ(body.left, 0);
    for (std::size_t p = 0; p < body.points.size(); ++p)
      after += body.points[p].mass * body.points[p].v + water[p] * body.points[p].w;
    EXPECT_LT((after - before - mass * settings.time_step * body.gravity).norm(), 1e-10);
  }
  for (const WetPoint<D>& point : body.points) now += point.water_mass;
  const WaterBudget& b = body.budget;
  EXPECT_NEAR((now - begin - b.entered + b.left + b.lost_between) / begin, 0, 1e-13);
  EXPECT_GT((b.entered + b.left) / begin, 1e-6);  // something has passed
  EXPECT_LE(b.runoff, b.supplied);
}

TEST(TwoPhaseBudgets, MomentumAndWaterCloseToRoundOff) {
  for (const bool mixed : {true, false})
    for (const Smoothing smoothing : {Smoothing::none, Smoothing::strain}) {
      const bool smooth_pressure = smoothing == Smoothing::none;
      expect_budgets<2>(
          {.time_step = 1e-4, .mixed = mixed, .smoothing = smoothing, .smooth_pressure = smooth_pressure});
      expect_budgets<3>(
          {.time_step = 1e-4, .mixed = mixed, .smoothing = smoothing, .smooth_pressure = smooth_pressure});
    }
}

/// Random nodal velocities of both phases on a disturbed body, ready for the increments.
template <int D>
WetBody<D> make_moving_nodes(const WetSettings& settings) {
  WetBody<D> body = make_disturbed<D>();
  body.gravity.setZero();
  classify_wet_elements(body, settings);
  average_wet_state(body);
  map_wet_points(body);
  add_wet_forces(body);
  std::mt19937 random(7);
  for (WetNode<D>& node : body.nodes)
    for (int d = 0; d < D; ++d) {
      node.v[d] = 1e-3 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
      node.w[d] = 1e-3 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    }
  compute_wet_increments(body, settings);
  return body;
}

TEST(TwoPhaseBudgets, PressuresDoTheWorkThatTheStorageOfWaterGets) {
  const WetSettings settings{.time_step = 1};
  WetBody<3> body = make_moving_nodes<3>(settings);
  double of_nodes = 0, of_points = 0;
  for (const WetNode<3>& node : body.nodes) {
    const Vector<3> on_water = node.water_content() * node.water_force;
    of_nodes -= node.w.dot(on_water) + node.v.dot(node.force - on_water);
  }
  for (const WetPoint<3>& point : body.points) {
    const WetCell& cell = at(body.cells, point.element);
    const double s = soil_of(body, point).water.saturation(point.pressure);
    of_points +=
        cell.stretch * point.volume * point.pressure * (s * cell.strain_increment.trace() + cell.flux_divergence);
  }
  EXPECT_NEAR(of_nodes / of_points, 1, 1e-12);
}

TEST(TwoPhaseBudgets, SaturatedSoilOfOnePorosityFollowsThePrintedStorageEquation) {
  // (2.83): Δp = K_w/n [(1−n) tr Δε_s + n tr Δε_w]
  const double dt = 1e-4;
  WetBody<2> body = make_wet_body(make_box<2>({5, 5}, {1.0, 1.0}), make_table_soil());
  fill_wet(
      body, 0.4, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>&) { return -1e4; });
  classify_wet_elements(body, {});
  map_wet_points(body);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const auto& x = body.mesh.nodes[i];
    body.nodes[i].v = {1e-3 * std::sin(5 * x[0]), 2e-3 * x[1]};
    body.nodes[i].w = {-2e-3 * x[0] * x[1], 1e-3 * std::cos(4 * x[1])};
  }
  compute_wet_increments(body, {.time_step = dt});
  const std::vector<WetPoint<2>> before = body.points;
  update_wet_points(body, {.time_step = dt});
  double largest = 0;
  for (std::size_t p = 0; p < before.size(); ++p) {
    const Gradients<2> b = shape_gradients(body.mesh, before[p].element);
    double solid = 0, water = 0;
    for (int i = 0; i <= 2; ++i) {
      const WetNode<2>& node = at(body.nodes, node_of(body.mesh, before[p].element, i));
      solid += dt * node.v.dot(b.row(i)), water += dt * node.w.dot(b.row(i));
    }
    const double printed = 2.15e9 / 0.4 * (0.6 * solid + 0.4 * water);
    EXPECT_NEAR(body.points[p].pressure - before[p].pressure, printed, 1e-4 * 1e3);
    largest = std::max(largest, std::abs(printed));
  }
  EXPECT_GT(largest, 1e3);
}

}  // namespace
}  // namespace talus::reference
