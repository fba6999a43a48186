// SPDX-License-Identifier: MIT
// The plain two-velocity step on a failing wet slope with all options: fields remain finite, the masses of grains and
// water are conserved, and no node is faster than free fall.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "reference/wet_slope.hpp"

namespace talus::reference {
namespace {

template <int D>
void expect_sound_failure(const WetSettings& settings, double end) {
  WetBody<D> body = make_wet_slope<D>();
  double grains = 0, water = 0, now = 0;
  std::vector<Vector<D>> start;
  for (const WetPoint<D>& point : body.points) {
    grains += point.mass, water += point.water_mass;
    start.push_back(point.x);
  }
  for (double t = 0; t < end; t += settings.time_step) step(body, settings);
  ASSERT_EQ(body.left, 0);
  double moved = 0, fastest = 0, least = 1, most = 0, changed = 0;
  for (std::size_t p = 0; p < start.size(); ++p) {
    const WetPoint<D>& point = body.points[p];
    ASSERT_TRUE(std::isfinite(point.pressure) && point.sigma.allFinite());
    grains -= point.mass, now += point.water_mass;
    moved = std::max(moved, (point.x - start[p]).norm());
    if (!soil_of(body, point).wet) continue;
    least = std::min(least, porosity(body, point)), most = std::max(most, porosity(body, point));
  }
  for (const WetNode<D>& node : body.nodes) fastest = std::max(fastest, node.v.norm());
  const WaterBudget& b = body.budget;
  changed = b.entered - b.left - b.lost_between;
  std::printf(
      "wet slope %dD: moved %.3f m, fastest %.3f m/s, porosity %.3f to %.3f; of the water: in %.3g, out %.3g, between "
      "%.3g, runoff %.3g\n",
      D, moved, fastest, least, most, b.entered / water, b.left / water, b.lost_between / water, b.runoff / water);
  EXPECT_NEAR(grains, 0, 1e-9);
  EXPECT_NEAR((now - water - changed) / water, 0, 1e-12);
  EXPECT_LT(std::abs(b.lost_between) / water, 1e-3);
  EXPECT_GT(b.supplied, b.runoff);
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(fastest, 3.0);
  EXPECT_GT(least, 0.1);
  EXPECT_LT(most, 0.8);
}

TEST(TwoPhaseSlope, FailsWithoutLosingGrainsOrWater) {
  const double dt2 = wet_slope_step(make_wet_slope<2>()), dt3 = wet_slope_step(make_wet_slope<3>());
  expect_sound_failure<2>({.time_step = dt2, .damping = 0.05, .smoothing = Smoothing::stable, .smooth_pressure = true},
                          0.8);
  expect_sound_failure<2>({.time_step = dt2, .damping = 0.05, .damped_force = DampedForce::net, .mixed = false}, 0.4);
  expect_sound_failure<3>(
      {.time_step = dt3, .damping = 0.05, .damped_force = DampedForce::net, .smoothing = Smoothing::strain}, 0.4);
}

/// Fastest node after 1,000 steps of a closed box of 1 m whose points began with random velocities of 1e-5 m/s.
double disturb(double conductivity, Drag drag, double courant) {
  Soil soil = make_table_soil();
  soil.water.conductivity = conductivity;
  WetBody<2> body = make_wet_body(make_box<2>({6, 6}, {1.0, 1.0}), soil);
  fix_wet_box(body, {1.0, 1.0});
  fill_wet(
      body, 0.4, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>&) { return 0.0; });
  std::mt19937 random(3);
  const auto draw = [&] {
    return 1e-5 * (2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1);
  };
  for (WetPoint<2>& point : body.points)
    for (int d = 0; d < 2; ++d) point.v[d] = draw(), point.w[d] = draw();
  const CoupledSoil limits = CoupledSoil::saturated(1e7 * 0.7 / 0.52, 0.4, 2.15e9, 2650, conductivity);
  WetSettings settings{.drag = drag, .frozen = true};
  settings.time_step = courant * critical_step(limits, smallest_altitude(body.mesh), 1, drag);
  double fastest = 0;
  for (int n = 0; n < 1000 && fastest < 1; ++n) {
    step(body, settings);
    fastest = 0;
    for (const WetNode<2>& node : body.nodes) fastest = std::max({fastest, node.v.norm(), node.w.norm()});
  }
  return fastest;
}

TEST(TwoPhaseStability, ImplicitDragIsStableAtTheFrictionlessLimitForAnyConductivity) {
  for (const double k : {1e-9, 1e-6, 1e-3, 1.0}) {
    EXPECT_LT(disturb(k, Drag::implicit_at_nodes, 1.0), 3e-5) << k;
    EXPECT_LT(disturb(k, Drag::explicit_as_source, 0.98), 3e-5) << k;
  }
  EXPECT_GT(disturb(1e-6, Drag::explicit_as_source, 1.05), 1);  // where drag decides, the explicit bound is sharp
}

}  // namespace
}  // namespace talus::reference
