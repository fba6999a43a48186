// SPDX-License-Identifier: MIT
// Conditions and options of the plain two-velocity step with closed-form solutions: evaporation limited by suction,
// given inflow and pressure, the mean water of a full element, effective stress of Khalili and Khabbaz.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

/// One node on a surface with a normal that is no axis.
WetBody<2> make_surface_node(const SurfaceCondition<2>& condition) {
  WetBody<2> body;
  body.mesh.nodes = {{0.0, 0.0}};
  body.nodes.resize(1);
  body.nodes[0].solid_mass = 3, body.nodes[0].water_mass = 0.8, body.nodes[0].whole_mass = 2;
  body.nodes[0].surface = Vector<2>(3, 4) / 10;
  body.solid_constraints.resize(1), body.water_constraints.resize(1);
  body.surface = {condition};
  return body;
}

/// θ(w−v)·n that is left of `before` [m/s].
double limit_flux(const WetBody<2>& body, double before) {
  const Vector<2> normal(0.6, 0.8);
  Vector<2> v = Vector<2>::Zero(), w = before / 0.4 * normal;
  limit_inflow(body, 0, v, w);
  EXPECT_NEAR((3 * v + 0.8 * (w - before / 0.4 * normal)).norm(), 0, 1e-15);  // momentum is kept
  return 0.4 * (w - v).dot(normal);
}

TEST(TwoPhaseConditions, EvaporationHasItsRateAndDecreasesBeforeItsSuctionLimit) {
  WetBody<2> body = make_surface_node({.kind = SurfaceKind::rain, .evaporation = 0.02, .suction_limit = 1e5});
  for (const auto& [suction, fraction] : {std::pair{-1e4, 1.0}, {8.9e4, 1.0}, {9.5e4, 0.5}, {1.1e5, 0.0}}) {
    body.nodes[0].suction = suction;
    EXPECT_NEAR(limit_flux(body, -0.1), 0.02 * fraction, 1e-15);
    EXPECT_NEAR(limit_flux(body, 0.1), 0.1, 1e-15);  // what leaves, leaves
  }
  body.surface[0].suction_limit = INFINITY;
  EXPECT_NEAR(limit_flux(body, 0), 0.02, 1e-15);
}

TEST(TwoPhaseConditions, GivenFluxIsPutRightEitherWay) {
  for (const double inflow : {0.03, -0.03}) {
    const WetBody<2> body = make_surface_node({.kind = SurfaceKind::flux, .inflow = inflow});
    for (const double before : {-0.1, 0.0, 0.1}) EXPECT_NEAR(limit_flux(body, before), -inflow, 1e-15);
  }
  EXPECT_NEAR(limit_flux(make_surface_node({.kind = SurfaceKind::closed}), 0.1), 0, 1e-15);
  EXPECT_NEAR(limit_flux(make_surface_node({.kind = SurfaceKind::pressure, .pressure = -1e3}), -0.1), -0.1, 1e-15);
}

TEST(TwoPhaseConditions, GivenPressureLoadsTheWaterAndPressesTheMixtureButDoesNotPullIt) {
  for (const double pressure : {-2e3, 2e3}) {
    WetBody<2> body = make_column<2>(2, 1.0, make_table_soil(), 0.4);
    body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::seepage});
    for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
      if (body.mesh.nodes[i][0] > 0.5) {
        body.water_constraints[i].fixed[0] = false;
        body.surface[i] = {.kind = SurfaceKind::pressure, .pressure = pressure};
      }
    classify_wet_elements(body, {});
    body.nodes.assign(body.mesh.nodes.size(), {});
    load_free_surface(body);
    Vector<2> water(0, 0), darcy(0, 0);
    for (const WetNode<2>& node : body.nodes) water += node.water_force, darcy += node.force;
    EXPECT_NEAR(water[0], 2 * pressure, 1e-9);  // a side of 2 m; at the top the nodes are of two kinds
    EXPECT_NEAR(darcy[0], std::min(0.0, 2 * pressure), 1e-9);
    EXPECT_EQ(water[1], 0);
  }
}

TEST(TwoPhaseConditions, WeightlessSoilUnderWaterIsAtRestHoweverFullItsSurfaceIs) {
  // Grains as heavy as water, and the water's pressure inside and outside: nothing moves, also where some of the points
  // of an element are left.
  Soil soil = make_table_soil();
  soil.grain_density = soil.water.density;
  for (const bool mixed : {false, true}) {
    WetBody<2> body = make_wet_body(make_box<2>({8, 8}, {2.0, 2.0}), soil);
    body.gravity = {0, -9.81};
    fix_wet_box(body, {2.0, 2.0});
    fill_wet(
        body, 0.4, 0, [](const Vector<2>& x) { return x[1] < 1.4; }, [](const Vector<2>&) { return 0.0; });
    body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::head, .head = 5});
    const double unit_weight = 9.81 * soil.water.density;
    std::erase_if(body.points, [](const WetPoint<2>& p) { return p.x[1] > 1.25 && p.id % 3 != 0; });
    for (WetPoint<2>& p : body.points) {
      p.pressure = -unit_weight * (5 - p.x[1]);
      p.water_mass = pore_volume(body, p) * soil.water.density;
    }
    classify_wet_elements(body, {.mixed = mixed});
    map_wet_points(body);
    add_wet_forces(body);
    load_free_surface(body);
    int loaded = 0;
    double largest = 0;
    for (std::size_t i = 0; i < body.nodes.size(); ++i) {
      const auto& x = body.mesh.nodes[i];
      if (x[0] < 1e-9 || x[0] > 2 - 1e-9 || x[1] < 1e-9 || body.nodes[i].solid_mass == 0) continue;
      largest = std::max({largest, body.nodes[i].force.norm(), body.nodes[i].water_force.norm()});
      loaded += body.nodes[i].surface.norm() > 0;
    }
    EXPECT_GT(loaded, 6);
    EXPECT_LT(largest, 1e-9 * unit_weight) << (mixed ? "mixed" : "points");
  }
}

TEST(TwoPhaseConditions, PointsOfAFullElementHoldTheirWaterAtOnePressure) {
  const Soil soil = make_retaining_soil();
  WetBody<2> body = make_column<2>(1, 1.0, soil, 0.4);
  double before = 0, after = 0, pores = 0;
  for (WetPoint<2>& point : body.points) {
    point.volume *= 1 + 0.1 * point.id;  // another porosity
    point.pressure = 3e3 * point.id - 2e3;
    point.water_mass =
        pore_volume(body, point) * soil.water.saturation(point.pressure) * water_density(soil.water, point.pressure);
    if (point.element == 0) before += point.water_mass, pores += pore_volume(body, point);
  }
  classify_wet_elements(body, {});
  average_wet_state(body);
  const std::vector<WetPoint<2>> once = body.points;
  average_wet_state(body);
  for (const WetPoint<2>& point : body.points) {
    const double holds = soil.water.saturation(point.pressure) * water_density(soil.water, point.pressure);
    EXPECT_NEAR(point.water_mass / (pore_volume(body, point) * holds), 1, 1e-14);
    EXPECT_NEAR(point.pressure, at(once, point.id).pressure, 1e-9);
    if (point.element != 0) continue;
    EXPECT_EQ(point.pressure, body.points[0].pressure);
    after += point.water_mass;
  }
  EXPECT_NEAR(after, before, 1e-15 * before);
  // It is not the mean of the pressures: that would hold other water.
  double mean = 0, volume = 0;
  for (const std::size_t p : body.cells[0].points) {
    mean += body.points[p].volume * (3e3 * body.points[p].id - 2e3), volume += body.points[p].volume;
  }
  mean /= volume;
  EXPECT_GT(std::abs(pores * soil.water.saturation(mean) * water_density(soil.water, mean) / before - 1), 1e-4);
}

TEST(TwoPhaseConditions, BishopsFactorIsOneUpToTheAirEntryAndThenThatOfKhaliliAndKhabbaz) {
  PoreWater water = make_retaining_soil().water;
  EXPECT_EQ(find_chi(water, 3e4), water.saturation(3e4));
  water.chi_air_entry = 1e4;
  for (const double p : {-5e4, 0.0, 1e4}) EXPECT_EQ(find_chi(water, p), 1);
  EXPECT_NEAR(find_chi(water, 1e5), 0.28183829, 1e-8);  // 10^-0.55
}

/// A column of 0.5 m without weight that dries from its top.
TEST(TwoPhaseConditions, ColumnDriesAtTheGivenRateAndUpToTheLimit) {
  const double n = 0.4, height = 0.5, h = 0.1, rate = 1e-4, limit = 1e4;
  Soil soil = make_retaining_soil();
  soil.skeleton.young_modulus = 1;
  WetBody<2> body = make_column<2>(5, h, soil, n);
  body.points.clear();
  fill_wet(
      body, n, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>&) { return 8e3; });
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::seepage});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    body.solid_constraints[i].fixed = {true, true};
    if (body.mesh.nodes[i][1] == height)
      body.surface[i] = {.kind = SurfaceKind::rain, .evaporation = rate, .suction_limit = limit};
  }
  const CoupledSoil limits{1.0, n, 0.7, n * 0.9 / 2e4 * std::exp(-0.5), 2650, 1000, 1e-4, 9.81};
  WetSettings settings{.mass_scaling = 400, .frozen = true};
  settings.time_step = 0.7 * critical_step(limits, smallest_altitude(body.mesh), 400, Drag::implicit_at_nodes);
  double t = 0, begin = 0, now = 0;
  for (const WetPoint<2>& point : body.points) begin += point.water_mass;
  for (; t < 20; t += settings.time_step) step(body, settings);
  EXPECT_NEAR(body.budget.left / (1000 * rate * h * t), 1,
              0.005);                  // water in motion may overshoot, and then more leaves
  EXPECT_EQ(body.budget.supplied, 0);  // no rain
  for (; t < 600; t += settings.time_step) step(body, settings);
  for (const WetPoint<2>& point : body.points) {
    now += point.water_mass;
    EXPECT_LT(point.pressure, 1.001 * limit);
    EXPECT_GT(point.pressure, 0.9 * limit);
  }
  EXPECT_LT(body.budget.left, 0.5 * 1000 * rate * h * t);
  EXPECT_NEAR((begin - now) / body.budget.left, 1, 1e-9);
}

}  // namespace
}  // namespace talus::reference
