// SPDX-License-Identifier: MIT
// The Darcy formulation on a device: the kernels, emulated on the processor, against the MPM step.

#include <gtest/gtest.h>

#include "golden/device_comparison.hpp"
#include "golden/wet_bodies.hpp"
#include "golden/wet_translation.hpp"
#include "reference/plain_mixture.hpp"

namespace talus {
namespace {

using namespace golden;
using reference::DarcyBody;
using reference::DarcySettings;
using reference::Smoothing;

struct Case {
  std::string name;
  bool mixed = true, frozen = false;
  Smoothing smoothing = Smoothing::none;
  bool given = false;  ///< the nodes start from pressures that are given
  int filter_interval = 0;
};

std::vector<Case> list_cases() {
  return {{.name = "mixed", .filter_interval = 7},
          {.name = "stable", .smoothing = Smoothing::stable},
          {.name = "points", .mixed = false, .smoothing = Smoothing::strain},
          {.name = "frozen", .frozen = true},
          {.name = "given pressures", .given = true},
          {.name = "given pressures, frozen", .frozen = true, .given = true}};
}

template <int D>
struct WetCase {
  mpm::Body<D> body;
  mpm::StepOptions<D> options;
};

template <int D>
WetCase<D> make_case(const reference::WetBody<D>& wet, const Case& c) {
  DarcyBody<D> plain{wet};
  for (auto& p : plain.points) p.w = p.v;
  DarcySettings settings;
  settings.time_step = 0.5 * reference::smallest_altitude(wet.mesh) / std::sqrt(5e6 * 0.7 / 0.52 / 2000);
  settings.mixed = c.mixed;
  settings.frozen = c.frozen;
  settings.smoothing = c.smoothing;
  WetCase<D> made{translate<D>(plain, reference::wet_slope_curves(), 3),
                  translate(settings, static_cast<const reference::WetBody<D>&>(plain))};
  made.options.darcy = true;
  made.options.monitor = true;
  made.options.pressure_tolerance = 1e-13;
  if (c.given)
    for (const auto& x : plain.mesh.nodes) made.body.water.darcy.pressure.push_back(9810 * (x[D - 1] - 1.7));
  return made;
}

template <int D>
void compare(const reference::WetBody<D>& wet, const Case& c, int steps) {
  const WetCase<D> made = make_case(wet, c);
  compare_on_device(made.body, made.options, c.name, steps, c.filter_interval);
}

TEST(DeviceWater, PlaneSlopeIsTheSamePointByPoint) {
  for (const Case& c : list_cases()) compare(make_moving_slope<2>(), c, 100);
}

TEST(DeviceWater, SpatialSlopeIsTheSamePointByPoint) {
  for (const Case& c : list_cases()) compare(make_moving_slope<3>(), c, 30);
}

TEST(DeviceWater, EveryConditionIsTheSame) {
  compare(make_many_conditions<2>(), {.name = "conditions"}, 60);
  compare(make_many_conditions<3>(), {.name = "conditions in space"}, 20);
}

TEST(DeviceWater, GapsInTheSoilAreTheSame) {
  auto plane = make_moving_slope<2>();
  for (const auto& x : {reference::Vector<2>{1.1, 2.2}, {3.1, 1.4}, {4.6, 0.6}}) reference::empty_element<2>(plane, x);
  compare(plane, {.name = "gaps"}, 60);
  auto space = make_moving_slope<3>();
  reference::empty_element<3>(space, {2.1, 1.4, 1.1});
  compare(space, {.name = "gap in space"}, 20);
}

TEST(DeviceWater, WallThatIsPushedInIsTheSame) {
  auto body = make_moving_slope<2>();
  reference::push_left_wall(body.mesh, body.solid_constraints);
  for (const Case& c : list_cases()) compare(body, c, 60);
}

TEST(DeviceWater, WaterThatRootsDrawIsTheSame) {
  for (const bool moving : {false, true}) {
    WetCase<2> made = make_case(make_moving_slope<2>(), {.name = "roots", .frozen = !moving});
    for (const double rate : {2e-3, 5e-4}) {
      mpm::RootUptake uptake;
      uptake.rate.time = {0};
      uptake.rate.value = {rate};
      uptake.reduction.suctions = {-1e6, -1e6, 4e3, 4e4};
      uptake.weight.resize(static_cast<std::size_t>(made.body.points.size()));
      for (std::size_t i = 0; i < uptake.weight.size(); ++i) uptake.weight[i] = i % 3 == 0 ? 0.02 : 0.0;
      made.body.water.uptakes.push_back(uptake);
    }
    compare_on_device(made.body, made.options, "roots", 60);
  }
}

/// Water that the device has after `steps`, brought back.
template <int D>
mpm::Body<D> run_on_device(WetCase<D> made, int steps, const mpm::Emulation& how) {
  mpm::gather_nodal_sums(made.body, made.options);
  mpm::DeviceStepper<D> device(make_tested_device<D>(how));
  for (int s = 0; s < steps; ++s) device.step(made.body, made.options);
  device.copy_back(made.body);
  return made.body;
}

/// The result does not depend on the number of threads that run together. There are fewer steps, since the threads
/// synchronise after each of hundreds of kernels.
TEST(DeviceWater, OrderOfThreadsChangesNoBit) {
  const WetCase<2> made = make_case(make_many_conditions<2>(), {.name = "stable", .smoothing = Smoothing::stable});
  const auto compare_bits = [&](const mpm::Emulation& how, int steps) {
    const mpm::Body<2> forwards = run_on_device(made, steps, {}), other = run_on_device(made, steps, how);
    EXPECT_EQ(forwards.points.data, other.points.data);
    EXPECT_EQ(forwards.points.id, other.points.id);
    EXPECT_EQ(forwards.water.darcy.own, other.water.darcy.own);
    EXPECT_EQ(forwards.work.pore_water, other.work.pore_water);
  };
  compare_bits({.backwards = true}, 60);
  compare_bits({.threads = 2, .block = 1}, 6);
}

}  // namespace
}  // namespace talus
