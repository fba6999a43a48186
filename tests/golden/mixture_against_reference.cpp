// SPDX-License-Identifier: MIT
// The step of the Darcy formulation equals the plain one at every point, to round-off and the residual of the linear
// solver.

#include <gtest/gtest.h>

#include "golden/wet_bodies.hpp"
#include "golden/wet_run.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "reference/plain_mixture.hpp"

namespace talus {
namespace {

using reference::DarcyBody;
using reference::DarcySettings;
using reference::Smoothing;

template <int D>
double drained_step(const reference::WetBody<D>& body) {
  return 0.5 * reference::smallest_altitude(body.mesh) / std::sqrt(5e6 * 0.7 / 0.52 / 2000);
}

struct Case {
  std::string name;
  bool mixed = true, frozen = false;
  Smoothing smoothing = Smoothing::none;
  double damping = 0;
  bool given = false;  ///< the nodes start from pressures that are given
  bool small = false;  ///< some points are smaller than their grains
};

/// As a volume that smoothing leads may become: below that of the grains, with the water of a thousandth of itself.
template <int D>
void shrink(DarcyBody<D>& plain, mpm::Body<D>& body) {
  using P = mpm::Points<D>;
  int small = 0;
  for (auto& point : plain.points) {
    if (!(point.water_mass > 0 && point.x[0] > 1 && point.x[0] < 1.6)) continue;
    point.volume *= 0.45;
    point.water_mass = 0.4 * point.volume;
    small += reference::pore_volume(plain, point) < 0;
    const std::int64_t place = body.points.place[static_cast<std::size_t>(point.id)];
    double* fields = body.points.slot(place / lane_width) + place % lane_width;
    fields[P::volume * lane_width] = point.volume;
    fields[(body.water.first_field + mpm::WaterFields<D>::mass) * lane_width] = point.water_mass;
  }
  ASSERT_GT(small, 3);
}

template <int D>
void expect_same(const reference::WetBody<D>& wet, const Case& c, int steps) {
  SCOPED_TRACE(c.name);
  const reference::Curves curves = reference::wet_slope_curves();
  DarcyBody<D> plain{wet};
  for (auto& p : plain.points) p.w = p.v;
  DarcySettings settings;
  settings.time_step = drained_step(wet);
  settings.mixed = c.mixed;
  settings.frozen = c.frozen;
  settings.smoothing = c.smoothing;
  settings.damping = c.damping;
  mpm::Body<D> body = golden::translate<D>(plain, curves, 3);
  mpm::StepOptions<D> options = golden::translate(settings, static_cast<const reference::WetBody<D>&>(plain));
  options.darcy = true;
  options.pressure_tolerance = 1e-13;
  if (c.given) {
    std::vector<double> pressures;
    for (const auto& x : plain.mesh.nodes) pressures.push_back(9810 * (x[D - 1] - 1.7));
    reference::start_from_pressures(plain, pressures);
    body.water.darcy.pressure = pressures;
  }
  if (c.small) shrink(plain, body);
  mpm::gather_nodal_sums(body, options);
  std::vector<double> point_scales, budget_scales;
  for (int s = 1; s <= steps && !testing::Test::HasFatalFailure(); ++s) {
    reference::step<D>(plain, settings);
    mpm::step(body, options);
    golden::expect_close(golden::compare_points<D>(plain, body), point_scales, c.name, s);
    golden::expect_close(golden::compare_budgets<D>(plain, body), budget_scales, c.name, s);
    EXPECT_EQ(plain.left, static_cast<int>(body.lost.size())) << "step " << s;
    if (s == steps / 2) mpm::gather_nodal_sums(body, options);
  }
}

std::vector<Case> list_cases() {
  return {{.name = "mixed"},
          {.name = "stable", .smoothing = Smoothing::stable},
          {.name = "points", .mixed = false, .smoothing = Smoothing::strain},
          {.name = "frozen", .frozen = true},
          {.name = "given pressures", .given = true},
          {.name = "given pressures, frozen", .frozen = true, .given = true}};
}

TEST(MixtureAgainstReference, PlaneSlopeIsTheSamePointByPoint) {
  for (const Case& c : list_cases()) expect_same(golden::make_moving_slope<2>(), c, 100);
}

TEST(MixtureAgainstReference, SpatialSlopeIsTheSamePointByPoint) {
  for (const Case& c : list_cases()) expect_same(golden::make_moving_slope<3>(), c, 30);
}

TEST(MixtureAgainstReference, EveryConditionIsTheSame) {
  expect_same(golden::make_many_conditions<2>(), {.name = "conditions"}, 60);
  expect_same(golden::make_many_conditions<3>(), {.name = "conditions in space"}, 20);
}

TEST(MixtureAgainstReference, RealWaterIsTheSame) {
  const auto body = golden::set_in_motion(golden::soften(reference::make_wet_slope<2>(), 2.2e9), 1);
  expect_same(body, {.name = "real water"}, 60);
}

TEST(MixtureAgainstReference, GapsInTheSoilAreTheSame) {
  auto plane = golden::make_moving_slope<2>();
  for (const auto& x : {reference::Vector<2>{1.1, 2.2}, {3.1, 1.4}, {4.6, 0.6}}) reference::empty_element<2>(plane, x);
  expect_same(plane, {.name = "gaps"}, 60);
  auto space = golden::make_moving_slope<3>();
  reference::empty_element<3>(space, {2.1, 1.4, 1.1});
  expect_same(space, {.name = "gap in space"}, 20);
}

TEST(MixtureAgainstReference, SoilThatIsSmallerThanItsGrainsIsTheSame) {
  expect_same(golden::make_moving_slope<2>(), {.name = "small", .small = true}, 20);
}

TEST(MixtureAgainstReference, WallThatIsPushedInIsTheSame) {
  auto body = golden::make_moving_slope<2>();
  reference::push_left_wall(body.mesh, body.solid_constraints);
  for (const Case& c : list_cases()) expect_same(body, c, 100);
}

template <int D>
void expect_bitwise_identical(const reference::WetBody<D>& wet, int steps) {
  DarcySettings settings;
  settings.time_step = drained_step(wet);
  settings.smoothing = Smoothing::stable;
  const mpm::Body<D> start = golden::translate<D>(DarcyBody<D>{wet}, reference::wet_slope_curves(), 3);
  const auto advance = [&](int threads) {
    mpm::Body<D> body = start;
    mpm::StepOptions<D> options = golden::translate(settings, wet);
    options.darcy = true;
    options.threads = threads;
    mpm::gather_nodal_sums(body, options);
    for (int s = 0; s < steps; ++s) mpm::step(body, options);
    return body;
  };
  const mpm::Body<D> one = advance(1);
  for (const int threads : {2, 3}) {
    const mpm::Body<D> other = advance(threads);
    EXPECT_EQ(one.points.data, other.points.data) << threads;
    EXPECT_EQ(one.water.darcy.change, other.water.darcy.change) << threads;
  }
}

TEST(MixtureAgainstReference, NumberOfThreadsDoesNotChangeABit) {
  expect_bitwise_identical(golden::make_moving_slope<2>(), 60);
  expect_bitwise_identical(golden::make_moving_slope<3>(), 20);
}

}  // namespace
}  // namespace talus
