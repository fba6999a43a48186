// SPDX-License-Identifier: MIT
// Flow through soil at rest in the plain step of the Darcy formulation: discharge through layers, infiltration against
// a fine solution of Richards' equation, runoff.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "golden/wet_bodies.hpp"
#include "physics/wet_columns.hpp"
#include "reference/plain_mixture.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

constexpr double g = 9.81, gamma_w = 1000 * g;

TEST(DarcyFlow, DischargeThroughLayersIsDarcysExactly) {
  const Soil loose = make_table_soil(1e-10), tight = make_table_soil(1e-11);
  DarcyBody<2> body{make_layered_column(loose, tight, 0.2)};
  DarcySettings settings;
  settings.frozen = true;
  settings.time_step = 1;
  for (int n = 0; n < 400; ++n) step<2>(body, settings);
  const WaterBudget before = body.budget;
  step<2>(body, settings);
  const double discharge = 0.125 * 0.4 / (1 / loose.water.conductivity + 1 / tight.water.conductivity);
  EXPECT_NEAR((body.budget.left - before.left) / (1000 * settings.time_step * discharge), 1, 2e-6)
      << "but for the compression of water";
  EXPECT_NEAR((body.budget.entered - before.entered) / (1000 * settings.time_step * discharge), 1, 2e-6)
      << "but for the compression of water";
}

DarcyBody<2> make_column_under_rain(const Soil& soil, double height, int cells, double n, double rain, double fraction,
                                    double jitter) {
  DarcyBody<2> body{make_column<2>(cells, height / cells, soil, n, jitter)};
  body.points.clear();
  fill_wet(
      body, n, 0, [](const Vector<2>&) { return true; }, [&](const Vector<2>& x) { return fraction * gamma_w * x[1]; });
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    body.solid_constraints[i].fixed = {true, true};
    if (body.mesh.nodes[i][1] == 0.0) body.water_constraints[i].fixed[1] = false;
  }
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::open});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (std::abs(body.mesh.nodes[i][1] - height) < 1e-12)
      body.surface[i] = {.kind = SurfaceKind::rain, .rain = {0, -rain}};
  body.gravity[1] = -g;
  std::vector<double> start;
  for (const auto& x : body.mesh.nodes) start.push_back(fraction * gamma_w * x[1]);
  start_from_pressures(body, start);
  return body;
}

TEST(DarcyFlow, InfiltrationFollowsRichardsEquationWithStepsOfAnyLength) {
  const double height = 1, n = 0.4, rain = 5e-5;
  const Soil soil = make_gardner_soil(3e-4);
  const int fine = 200, cells = 20;
  for (const double dt : {0.5, 10.0}) {
    DarcyBody<2> body = make_column_under_rain(soil, height, cells, n, rain, 1, 0);
    DarcySettings settings;
    settings.frozen = true;
    settings.time_step = dt;
    const auto sum_water = [&] {
      double water = 0;
      for (const WetPoint<2>& point : body.points) water += point.water_mass;
      return water;
    };
    const double begin = sum_water();
    for (const double t : {300.0, 1000.0}) {
      while (body.steps < std::lround(t / dt)) step<2>(body, settings);
      const std::vector<double> exact = solve_richards(soil, n, height, fine, rain, t);
      double suction = 0, saturation = 0;
      for (std::size_t i = 0; i < body.pressure.size(); ++i) {
        const double position = body.mesh.nodes[i][1] / height * fine - 0.5;
        const int low = std::clamp(static_cast<int>(position), 0, fine - 2);
        const double fraction = position - low, p = (1 - fraction) * at(exact, low) + fraction * at(exact, low + 1);
        suction = std::max(suction, std::abs(body.pressure[i] - p));
        saturation = std::max(saturation, std::abs(soil.water.saturation(body.pressure[i]) - soil.water.saturation(p)));
      }
      std::printf("mixture, infiltration, t %.0f s, %g s a step: suction within %.3g Pa, saturation within %.3g\n", t,
                  dt, suction, saturation);
      EXPECT_LT(suction, 0.003 * gamma_w * height);
      EXPECT_LT(saturation, 0.0015);
      EXPECT_NEAR((sum_water() - begin - body.budget.entered + body.budget.left) / begin, 0, 1e-12);
    }
  }
}

TEST(DarcyFlow, RainBeyondWhatTheSoilTakesRunsOff) {
  const double height = 0.5, n = 0.4, rain = 3e-4;
  const Soil soil = make_gardner_soil(3e-4);
  DarcyBody<2> body = make_column_under_rain(soil, height, 6, n, rain, 0.5, 0.2);
  DarcySettings settings;
  settings.frozen = true;
  settings.time_step = 2;
  while (body.steps < 3000) step<2>(body, settings);
  const WaterBudget before = body.budget;
  step<2>(body, settings);
  const double taken = 1000 * settings.time_step * soil.water.conductivity * height / 6;
  EXPECT_NEAR((body.budget.entered - before.entered) / taken, 1, 1e-5) << "the saturated conductivity";
  EXPECT_NEAR((body.budget.left - before.left) / taken, 1, 1e-5);
  for (const double p : body.pressure) EXPECT_NEAR(p, 0, 1);
}

/// Shear parts the points of thin bands, and elements inside the soil are left without any. A gap is no surface: water
/// at rest stays so.
TEST(DarcyRest, GapsInsideTheSoilDrainNothing) {
  DarcyBody<2> body{make_wet_body(make_box<2>({6, 12}, {0.6, 1.2}, 0), make_table_soil())};
  fix_wet_box(body, {0.6, 1.2});
  const auto hydrostatic = [](double y) { return -gamma_w * (1 - y); };
  fill_wet(
      body, 0.4, 0, [&](const Vector<2>& x) { return x[1] < 1; },
      [&](const Vector<2>& x) { return hydrostatic(x[1]); });
  for (const auto& x : {Vector<2>{0.3, 0.5}, {0.35, 0.52}, {0.2, 0.2}, {0.01, 0.7}}) empty_element<2>(body, x);
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::rain});
  body.gravity[1] = -g;
  for (auto& constraint : body.solid_constraints) constraint.fixed = {true, true};
  std::vector<double> start;
  for (const auto& x : body.mesh.nodes) start.push_back(hydrostatic(x[1]));
  start_from_pressures(body, start);
  DarcySettings settings;
  settings.frozen = true;
  settings.time_step = 10;
  while (body.steps < 50) step<2>(body, settings);
  for (std::size_t i = 0; i < body.pressure.size(); ++i) {
    if (std::isnan(body.pressure[i])) continue;
    EXPECT_NEAR(body.pressure[i], hydrostatic(body.mesh.nodes[i][1]), 1);
  }
  EXPECT_NEAR(body.budget.left, 0, 1e-9);
}

/// A soft column settles under water by 14 mm, and points pass from element to element. With one pressure per element
/// and smoothing it never rests.
TEST(DarcyRest, SoftColumnSettlesUnderRealWaterWithSmoothing) {
  Soil soil = make_table_soil();
  soil.skeleton = {.young_modulus = 1e6, .poisson_ratio = 0.3};
  soil.water.bulk_modulus = 2.2e9;
  soil.water.conductivity = 1e-3;
  DarcyBody<2> body{make_wet_body(make_box<2>({4, 26}, {0.4, 2.6}, 0.2), soil)};
  fix_wet_box(body, {0.4, 2.6});
  const auto hydrostatic = [](double y) { return -gamma_w * (3 - y); };
  fill_wet(
      body, 0.4, 0, [&](const Vector<2>& x) { return x[1] < 2; },
      [&](const Vector<2>& x) { return hydrostatic(x[1]); });
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::head, .head = 3});
  body.gravity[1] = -g;
  double begin = 0;
  for (const WetPoint<2>& point : body.points) begin += point.water_mass;
  DarcySettings settings;
  settings.smoothing = Smoothing::stable;
  settings.damping = 0.1;
  settings.mass_scaling = 100;
  settings.time_step = 0.9 * smallest_altitude(body.mesh) / std::sqrt(1e6 * 0.7 / 0.52 / 1990 / 100);
  while (body.steps * settings.time_step < 40) step<2>(body, settings);
  for (std::size_t i = 0; i < body.pressure.size(); ++i) {
    if (std::isnan(body.pressure[i])) continue;
    EXPECT_NEAR(body.pressure[i], hydrostatic(body.mesh.nodes[i][1]), 700) << "still draining";
  }
  double water = 0;
  for (const WetPoint<2>& point : body.points) {
    water += point.water_mass;
    EXPECT_LT(point.v.norm(), 2e-4);
  }
  EXPECT_EQ(body.left, 0);
  EXPECT_NEAR((water - begin - body.budget.entered + body.budget.left) / begin, 0, 1e-12);
}

/// An unsaturated slope of two soils in motion, under rain and flooded at its toe: points change their elements, and
/// elements fill and empty.
TEST(MixtureSlope, SlidesWithRealWaterAtTheStepOfTheDrainedWave) {
  DarcyBody<2> body{golden::set_in_motion(golden::soften(make_wet_slope<2>(), 2.2e9), 1)};
  DarcySettings settings;
  settings.smoothing = Smoothing::stable;
  settings.time_step = 0.8 * smallest_altitude(body.mesh) / std::sqrt(5e6 * 0.7 / 0.52 / 2000);
  const auto sum_water = [&] {
    double water = 0;
    for (const WetPoint<2>& point : body.points) water += point.water_mass;
    return water;
  };
  const double begin = sum_water();
  for (int n = 0; n < 200; ++n) {
    step<2>(body, settings);
    // ρ c v of soil that meets the bottom with 4 m/s, c of the drained wave, on which pressures are solved.
    for (const double p : body.pressure) ASSERT_FALSE(std::abs(p) > 2000 * 58 * 4) << "step " << n;
    for (const WetPoint<2>& point : body.points) {
      ASSERT_LT(point.v.norm(), 5) << "step " << n;
      ASSERT_GE(point.water_mass, 0) << "step " << n;
    }
  }
  EXPECT_EQ(body.left, 0);
  EXPECT_GT(body.budget.entered, 0);
  EXPECT_NEAR((sum_water() - begin - body.budget.entered + body.budget.left) / begin, 0, 1e-12);
}

}  // namespace
}  // namespace talus::reference
