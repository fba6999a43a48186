// SPDX-License-Identifier: MIT
// Unsaturated soil in the plain two-velocity step: sealed compression against the closed form, pressure from the mass
// of water, and infiltration against a fine finite-difference solution of Richards' equation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "physics/gravity.hpp"
#include "physics/wet_columns.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

/// van Genuchten in the form of (3.13): S = S_min + (1 − S_min) [1 + (s/p_ref)^(1/(1−λ))]^(−λ).
PoreWater make_van_genuchten(double reference, double lambda, double s_min) {
  PoreWater water;
  const double exponent = 1 / (1 - lambda);
  water.saturation = [=](double p) {
    return p <= 0 ? 1.0 : s_min + (1 - s_min) * std::pow(1 + std::pow(p / reference, exponent), -lambda);
  };
  water.saturation_slope = [=](double p) {
    if (p <= 0) return 0.0;
    const double x = std::pow(p / reference, exponent);
    return -(1 - s_min) * lambda * exponent * x / p * std::pow(1 + x, -lambda - 1);
  };
  return water;
}

TEST(TwoPhaseStorage, PressureIsThatAtWhichThePoresHoldTheirWater) {
  const PoreWater steep = make_van_genuchten(3e3, 0.7, 0.1);
  PoreWater kinked = steep;  // slope −1e-4/Pa from p = 0 on
  kinked.saturation = [](double p) { return std::clamp(1 - 1e-4 * p, 0.2, 1.0); };
  kinked.saturation_slope = [](double p) { return p > 0 && p < 8e3 ? -1e-4 : 0.0; };
  for (const PoreWater& water : {steep, kinked})
    for (const double p : {-1e5, -1.0, 0.0, 0.5, 60.0, 3e3, 7.9e3})
      for (const double guess : {-1e6, -3.0, 0.0, 1e-3, 100.0, 5e3, 1e5, 1e7}) {
        const double mass = 0.4 * water.saturation(p) * water_density(water, p);
        const double found = find_pressure(water, 0.4, mass, guess);
        // Round-off of the content over the stiffness of pores and water.
        const double stiffness = 1 / (1 / water.bulk_modulus - water.saturation_slope(p));
        EXPECT_NEAR(found, p, 1e-15 * stiffness + 1e-10 * std::abs(p)) << "guess " << guess;
      }
}

TEST(TwoPhaseStorage, DrynessBelowTheResidualSaturationIsTensionOfTheWater) {
  const PoreWater water = make_van_genuchten(3e3, 0.7, 0.1);
  const double p = find_pressure(water, 0.4, 0.4 * 0.0999 * 1000, 1e4);
  EXPECT_GT(p, 1e5);
  EXPECT_NEAR(water.saturation(p) * std::exp(-p / water.bulk_modulus), 0.0999, 1e-12);
}

TEST(TwoPhaseStorage, SealedCompressionChangesTheSuctionByTheClosedForm) {
  // A sealed box is compressed uniformly; no water leaves, so S' n' V' = S n V with n' V' = n V + ΔV.
  Soil soil = make_table_soil(1e-11);
  const PoreWater curve = make_van_genuchten(2e4, 0.5, 0.05);
  soil.water.saturation = curve.saturation, soil.water.saturation_slope = curve.saturation_slope;
  WetBody<2> body = make_wet_body(make_box<2>({4, 4}, {1.0, 1.0}), soil);
  fill_wet(
      body, 0.4, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>&) { return 3e4; });
  const double rate = -0.5, dt = 1e-5;
  double ratio = 1;
  classify_wet_elements(body, {});
  body.nodes.assign(body.mesh.nodes.size(), {});
  for (int n = 0; n < 4000; ++n) {
    for (WetCell& cell : body.cells) {
      cell = {};
      cell.gradient(0, 0) = cell.gradient(1, 1) = rate / 2;
      cell.strain_increment = dt * cell.gradient;
    }
    for (std::size_t p = 0; p < body.points.size(); ++p) at(body.cells, body.points[p].element).points.push_back(p);
    update_wet_points(body, {.time_step = dt});
    ratio *= 1 + rate * dt;
  }
  const double s0 = curve.saturation(3e4), s1 = s0 * 0.4 / (ratio - 0.6);
  const double e = (s1 - 0.05) / 0.95, closed = 2e4 * std::sqrt(std::pow(e, -2.0) - 1);  // λ = 1/2
  for (const WetPoint<2>& point : body.points) {
    EXPECT_NEAR(point.pressure / closed, 1, 1e-4);  // the closed form forgets that the water is compressible
    EXPECT_NEAR(porosity(body, point), (ratio - 0.6) / ratio, 1e-12);
  }
  EXPECT_LT(closed, 2.8e4);
  // And to round-off, with compressible water:
  for (const WetPoint<2>& point : body.points) {
    const double held = curve.saturation(point.pressure) * water_density(soil.water, point.pressure) * (ratio - 0.6);
    EXPECT_NEAR(held / (0.4 * s0 * water_density(soil.water, 3e4)), 1, 1e-11);
  }
}

TEST(TwoPhaseInfiltration, FollowsRichardsEquationAndKeepsItsWater) {
  const double height = 1, n = 0.4, a = 3e-4, rain = 5e-5;  // 1/a = 3.3 kPa; half of what the soil can take
  const Soil soil = make_gardner_soil(a);
  const int cells = 20, fine = 200;
  WetBody<2> body = make_column<2>(cells, height / cells, soil, n);
  body.points.clear();
  fill_wet(
      body, n, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>& x) { return gamma_w * x[1]; });
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    body.solid_constraints[i].fixed = {true, true};
    if (body.mesh.nodes[i][1] == 0.0) body.water_constraints[i].fixed[1] = false;
  }
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::open});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (body.mesh.nodes[i][1] == height) body.surface[i] = {.kind = SurfaceKind::rain, .rain = {0, -rain}};
  body.gravity[1] = -g;
  // Softest at the top, stiffest at the table: the whole column stays unsaturated.
  const CoupledSoil limits{1.0, n, 1.0, n * 0.8 * a, 2650, 1000, 1e-4, g};
  WetSettings settings{.mass_scaling = 400, .frozen = true};
  settings.time_step = 0.7 * critical_step(limits, smallest_altitude(body.mesh), 400, Drag::implicit_at_nodes);
  double begin = 0;
  for (const WetPoint<2>& point : body.points) begin += point.water_mass;
  double t = 0;
  for (const double end : {300.0, 1000.0, 4000.0}) {
    for (; t < end; t += settings.time_step) step(body, settings);
    const std::vector<double> exact = solve_richards(soil, n, height, fine, rain, t);
    double largest = 0, water = 0, content_error = 0;
    for (const WetCell& cell : body.cells) {
      double y = 0;
      for (std::size_t p : cell.points) y += body.points[p].x[1] / 3;
      const double position = y / height * fine - 0.5;
      const int low = std::clamp(static_cast<int>(position), 0, fine - 2);
      const double fraction = position - low, p = (1 - fraction) * at(exact, low) + fraction * at(exact, low + 1);
      largest = std::max(largest, std::abs(body.points[cell.points[0]].pressure - p));
      content_error = std::max(content_error, std::abs(soil.water.saturation(body.points[cell.points[0]].pressure) -
                                                       soil.water.saturation(p)));
    }
    for (const WetPoint<2>& point : body.points) water += point.water_mass;
    std::printf("infiltration, t %.0f s, %g s a step: suction within %.3g Pa, saturation within %.3g\n", t,
                settings.time_step, largest, content_error);
    EXPECT_LT(largest, 0.02 * gamma_w * height);
    EXPECT_LT(content_error, 0.01);
    const WaterBudget& b = body.budget;
    EXPECT_NEAR((water - begin - b.entered + b.left + b.lost_between) / begin, 0, 1e-12);
    EXPECT_NEAR(b.lost_between / begin, 0, 1e-14);
    EXPECT_LT(b.runoff,
              1e-3 * 1000 * rain * 300 * height / cells);  // all enters but the first drops, before water moves
    EXPECT_NEAR(b.supplied, 1000 * rain * t * height / cells, 1e-9 * b.supplied);
  }
}

TEST(TwoPhaseInfiltration, RainBeyondWhatTheSoilTakesRunsOffAndTheRestIsTheConductivity) {
  // Steady state under 3 k: saturated, unit gradient, inflow k; the surface takes up no more.
  const double height = 0.5, n = 0.4, rain = 3e-4;
  const Soil soil = make_gardner_soil(3e-4);
  WetBody<2> body = make_column<2>(6, height / 6, soil, n);
  body.points.clear();
  fill_wet(
      body, n, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>& x) { return 0.5 * gamma_w * x[1]; });
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    body.solid_constraints[i].fixed = {true, true};
    if (body.mesh.nodes[i][1] == 0.0) body.water_constraints[i].fixed[1] = false;
  }
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::open});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (body.mesh.nodes[i][1] == height) body.surface[i] = {.kind = SurfaceKind::rain, .rain = {0, -rain}};
  body.soils[0].water.bulk_modulus = 2e6;
  body.gravity[1] = -g;
  const CoupledSoil limits = CoupledSoil::saturated(1.0, n, 2e6, 2650, 1e-4);
  WetSettings settings{.mass_scaling = 1e4, .frozen = true};
  settings.time_step = 0.8 * critical_step(limits, smallest_altitude(body.mesh), 1e4, Drag::implicit_at_nodes);
  for (double t = 0; t < 2000; t += settings.time_step) step(body, settings);
  const WaterBudget before = body.budget;
  const int steps = 500;
  for (int s = 0; s < steps; ++s) step(body, settings);
  const double per_rate = 1000 * height / 6 * steps * settings.time_step;
  EXPECT_NEAR((body.budget.supplied - before.supplied) / per_rate / rain, 1, 1e-9);
  EXPECT_NEAR((body.budget.entered - before.entered) / per_rate / 1e-4, 1, 0.01);
  EXPECT_NEAR((body.budget.runoff - before.runoff) / per_rate / 2e-4, 1, 0.01);
}

}  // namespace
}  // namespace talus::reference
