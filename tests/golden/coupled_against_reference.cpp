// SPDX-License-Identifier: MIT
// The step of the two-velocity formulation equals the plain one to round-off, by point and by mass, for every option,
// condition and dimension, in wet slopes that fail, slide, are dry at the crest and flooded at the toe. Damping is off
// except where everything moves, because Cundall's sign(v) amplifies round-off at a node at rest to a finite force.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "golden/wet_bodies.hpp"
#include "golden/wet_run.hpp"

namespace talus {
namespace {

using golden::expect_same;
using golden::make_many_conditions;
using golden::make_moving_slope;
using golden::Seen;
using golden::stable_step;
using golden::Variant;
using reference::DampedForce;
using reference::Drag;
using reference::Smoothing;
using reference::WetBody;
using reference::WetSettings;

std::vector<Variant> all_variants(double dt) {
  using enum Smoothing;
  return {
      {"points", {.time_step = dt, .mixed = false, .objective = false}},
      {"points objective", {.time_step = dt, .mixed = false}},
      {"points smoothed", {.time_step = dt, .mixed = false, .smoothing = strain, .smooth_pressure = true}},
      {"points stable", {.time_step = dt, .mixed = false, .smoothing = stable}},
      {"mixed", {.time_step = dt}, 1, 1},
      {"mixed scaled", {.time_step = dt, .mass_scaling = 4}},
      {"mixed smoothed", {.time_step = dt, .smoothing = strain}},
      {"mixed exchange", {.time_step = dt, .exchange_water = true}},
      {"points exchange",
       {.time_step = dt, .mixed = false, .smoothing = strain, .smooth_pressure = true, .exchange_water = true}},
      {"mixed stable", {.time_step = dt, .smoothing = stable, .smooth_pressure = true}},
      {"mixed pressure smoothed, small strain", {.time_step = dt, .smooth_pressure = true, .objective = false}},
      {"ten times as permeable", {.time_step = dt}, 10},
      {"frozen", {.time_step = dt, .objective = false, .frozen = true}},
      {"frozen stable", {.time_step = dt, .smoothing = stable, .smooth_pressure = true, .frozen = true}},
      {"frozen points", {.time_step = dt, .mixed = false, .smoothing = strain, .frozen = true}},
  };
}

template <int D>
void expect_all_same(const WetBody<D>& body, int steps, bool must_move = true) {
  for (const Variant& v : all_variants(stable_step(body))) {
    SCOPED_TRACE(v.name);
    const Seen seen = expect_same(body, v, steps);
    if (testing::Test::HasFatalFailure()) return;
    EXPECT_GT(seen.largest_plastic, 0) << v.name << ": the case must yield to test anything";
    EXPECT_GT(seen.entered, 0) << v.name;
    EXPECT_GT(seen.left_water, 0) << v.name;
    if (must_move && !v.settings.frozen) {
      EXPECT_GT(seen.changed, 0) << v.name << ": points must change their elements";
    }
  }
}

TEST(CoupledAgainstReference, PlaneSlopeIsTheSamePointByPoint) {
  expect_all_same(make_moving_slope<2>(), 150);
}

TEST(CoupledAgainstReference, SpatialSlopeIsTheSamePointByPoint) {
  expect_all_same(make_moving_slope<3>(), 60);
}

TEST(CoupledAgainstReference, WetAndDrySoilsInOneElementAreTheSame) {
  WetBody<2> body = make_moving_slope<2>();
  for (auto& p : body.points) {
    if (std::sin(3 * p.x[0]) * std::sin(4 * p.x[1]) < 0.5) continue;
    p.material = 2;
    p.water_mass = p.pressure = 0;
    p.w.setZero();
  }
  expect_all_same(body, 150);
}

/// Wet soil is driven into dry soil and back out of it: elements become wet or dry that are never empty.
TEST(CoupledAgainstReference, WetSoilThatEntersDrySoilIsTheSame) {
  WetBody<2> body = make_moving_slope<2>(0);
  for (auto& p : body.points) {
    const bool dry = p.x[0] < 1.5 || (p.x[0] > 4 && p.x[0] < 4.5);
    p.v[0] = dry ? 0 : -3;
    p.w = p.v;
    if (!dry) continue;
    p.material = 2;
    p.water_mass = p.pressure = 0;
  }
  for (const bool mixed : {true, false})
    expect_same(body, {"into dry soil", {.time_step = stable_step(body), .mixed = mixed}}, 200);
}

TEST(CoupledAgainstReference, ExplicitDragIsTheSame) {
  const WetBody<2> body = make_moving_slope<2>();
  const double dt = stable_step(body, Drag::explicit_as_source);
  for (const bool mixed : {true, false})
    expect_same(body, {"explicit", {.time_step = 20 * dt, .drag = Drag::explicit_as_source, .mixed = mixed}, 100}, 150);
}

TEST(CoupledAgainstReference, FastLandslideThatEmptiesAndFillsElementsIsTheSame) {
  const WetBody<2> plane = make_moving_slope<2>(4);
  const Seen seen = expect_same(plane, {"fast", {.time_step = stable_step(plane)}}, 400);
  EXPECT_GT(seen.emptied, 5);
  EXPECT_GT(seen.occupied, 5);
  const WetBody<3> spatial = make_moving_slope<3>(4);
  expect_same(spatial, {"fast", {.time_step = stable_step(spatial), .smoothing = Smoothing::stable}}, 150);
}

TEST(CoupledAgainstReference, SoilThatLeavesTheGridTakesItsWaterWithIt) {
  WetBody<2> body = make_moving_slope<2>(4);
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (body.mesh.nodes[i][0] > 7.9) body.solid_constraints[i].fixed[0] = body.water_constraints[i].fixed[0] = false;
  for (auto& p : body.points) p.v[0] = p.w[0] = 4;
  const Seen seen = expect_same(body, {"outflow", {.time_step = stable_step(body)}}, 200);
  EXPECT_GT(seen.left, 5);
}

TEST(CoupledAgainstReference, EveryConditionOfTheSurfaceIsTheSame) {
  const WetBody<2> plane = make_many_conditions<2>();
  const WetBody<3> spatial = make_many_conditions<3>();
  for (const bool mixed : {true, false}) {
    expect_same(plane, {"conditions", {.time_step = stable_step(plane), .mixed = mixed}}, 150);
    expect_same(spatial, {"conditions", {.time_step = stable_step(spatial), .mixed = mixed}}, 60);
  }
  expect_same(plane, {"conditions frozen", {.time_step = stable_step(plane), .frozen = true}}, 150);
}

/// Nodes that may slide along inclined planes only: both phases, the grains alone, the water alone.
TEST(CoupledAgainstReference, InclinedFixedDirectionsAreTheSame) {
  WetBody<2> body = make_moving_slope<2>();
  const reference::Vector<2> normal(0.6, -0.8);
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    const double x = body.mesh.nodes[i][0], y = body.mesh.nodes[i][1];
    if (x < 0.1 || x > 7.9 || y < 0.1) continue;
    if (std::abs(y - 1) < 0.2 && x < 4) body.solid_constraints[i].normal = normal;
    if (std::abs(y - 1) < 0.2 && x > 2 && x < 6) body.water_constraints[i].normal = normal;
  }
  const double dt = 20 * stable_step(body, Drag::explicit_as_source);
  expect_same(body, {"inclined", {.time_step = stable_step(body)}}, 150);
  expect_same(body, {"inclined, explicit", {.time_step = dt, .drag = Drag::explicit_as_source}, 100}, 150);
}

TEST(CoupledAgainstReference, WallThatIsPushedInIsTheSame) {
  WetBody<2> body = make_moving_slope<2>();
  reference::push_left_wall(body.mesh, body.solid_constraints);
  expect_same(body, {"pushed", {.time_step = stable_step(body)}}, 150);
  expect_same(body, {"pushed, damped", {.time_step = stable_step(body), .damping = 0.1}}, 150);
}

TEST(CoupledAgainstReference, DampingOfSoilThatMovesEverywhereIsTheSame) {
  const WetBody<2> body = make_moving_slope<2>(2);
  for (const DampedForce force : {DampedForce::net, DampedForce::without_drag})
    expect_same(
        body,
        {"damped", {.time_step = stable_step(body), .damping = 0.1, .water_damping = 0.05, .damped_force = force}},
        150);
}

TEST(CoupledAgainstReference, OtherCurvesAndBishopsFactorAreTheSame) {
  const material::VanGenuchten retention{0.05, 0.98, 1e4, 0.4};
  using enum material::SaturationMeasure;
  const std::vector<reference::Curves> all = {{retention, material::Mualem{0.4, total}},
                                              {retention, material::Mualem{0.4, effective}},
                                              {material::LinearRetention::from_scale(0.2, 1, 6e4), material::Hillel{2}},
                                              {material::ConstantSaturation{}, material::ConstantConductivity{}}};
  for (const reference::Curves& curves : all) {
    WetBody<2> body = reference::make_wet_slope<2>();
    for (reference::Soil& soil : body.soils) {
      reference::set_curves(soil.water, curves);
      soil.water.chi_air_entry = 5e3;
    }
    body = golden::set_in_motion(golden::soften(body, golden::soft_water), 1);
    expect_same(body, {"curves", {.time_step = stable_step(body)}}, 100, curves);
  }
}

template <int D>
void expect_bitwise_identical(const WetBody<D>& plain, WetSettings settings, int steps) {
  std::vector<mpm::Body<D>> bodies;
  for (const int threads : {1, 2}) {
    bodies.push_back(golden::translate(plain, reference::wet_slope_curves(), 7));
    mpm::StepOptions<D> options = golden::translate(settings, plain);
    options.threads = threads;
    mpm::gather_nodal_sums(bodies.back(), options);
    for (int s = 0; s < steps; ++s) mpm::step(bodies.back(), options);
  }
  for (int id = 0; id < bodies[0].points.size(); ++id) {
    ASSERT_EQ(mpm::is_present(bodies[0], id), mpm::is_present(bodies[1], id));
    if (!mpm::is_present(bodies[0], id)) continue;
    const auto p = mpm::view_point(bodies[0], id), q = mpm::view_point(bodies[1], id);
    ASSERT_EQ(p.position, q.position);
    ASSERT_EQ(p.velocity, q.velocity);
    ASSERT_EQ(p.water_velocity, q.water_velocity);
    ASSERT_EQ(p.stress, q.stress);
    ASSERT_EQ(p.pressure, q.pressure);
    ASSERT_EQ(p.water_mass, q.water_mass);
  }
  for (std::size_t c = 0; c < bodies[0].water.budgets.size(); ++c) {
    EXPECT_EQ(bodies[0].water.budgets[c].entered, bodies[1].water.budgets[c].entered);
    EXPECT_EQ(bodies[0].water.budgets[c].left, bodies[1].water.budgets[c].left);
    EXPECT_EQ(bodies[0].water.budgets[c].runoff, bodies[1].water.budgets[c].runoff);
  }
  EXPECT_EQ(bodies[0].water.lost_between, bodies[1].water.lost_between);
}

TEST(CoupledAgainstReference, NumberOfThreadsDoesNotChangeABit) {
  const auto plane = make_many_conditions<2>();
  const auto spatial = make_many_conditions<3>();
  for (const Smoothing smoothing : {Smoothing::none, Smoothing::stable}) {
    WetSettings settings{.time_step = stable_step(plane), .smoothing = smoothing, .smooth_pressure = true};
    expect_bitwise_identical(plane, settings, 300);
    settings.time_step = stable_step(spatial);
    expect_bitwise_identical(spatial, settings, 100);
  }
}

}  // namespace
}  // namespace talus
