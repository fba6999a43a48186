// SPDX-License-Identifier: MIT
// The kernels of a GPU, run on this processor one thread after the other, against the engine: point by point the same
// to round-off, for every option and dimension. What a GPU adds is the launch.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "golden/plain_translation.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/device/device_stepper.hpp"
#include "mpm/device/emulated.hpp"

namespace talus {
namespace {

using namespace golden;

template <int D>
mpm::StepOptions<D> make_options(const mpm::Body<D>& body, const Variant& v,
                                 const std::type_identity_t<Vec<D>>& gravity) {
  mpm::StepOptions<D> options;
  options.dt = 0.4 * mpm::find_critical_step(body, 1.0).dt;
  options.gravity = gravity;
  options.mass_scaling = v.mass_scaling;
  options.mixed = v.mixed;
  options.smoothing = translate(v.smoothing);
  options.objective = v.objective;
  options.moving = !v.frozen;
  return options;
}

/// `share` of the largest value of a field.
struct Largest {
  double difference = 0, value = 0;
  void add(double a, double b) {
    difference = std::max(difference, std::abs(a - b));
    value = std::max(value, std::abs(a));
  }
};

/// All that points and nodes have, to 1e-10 of the largest.
template <int D>
void expect_same(const mpm::Body<D>& engine, const mpm::Body<D>& device, const std::string& name) {
  constexpr double tolerance = 1e-10;
  Largest position, velocity, stress, strain, volume;
  EXPECT_EQ(engine.points.element, device.points.element) << name;
  for (int id = 0; id < engine.points.size(); ++id) {
    ASSERT_EQ(mpm::is_present(engine, id), mpm::is_present(device, id)) << name;
    if (!mpm::is_present(engine, id)) continue;
    const auto p = mpm::view_point(engine, id), q = mpm::view_point(device, id);
    for (std::size_t d = 0; d < D; ++d) {
      position.add(p.position[d], q.position[d]);
      velocity.add(p.velocity[d], q.velocity[d]);
    }
    for (std::size_t i = 0; i < p.stress.size(); ++i) {
      stress.add(p.stress[i], q.stress[i]);
      strain.add(p.strain[i], q.strain[i]);
    }
    volume.add(p.volume, q.volume);
    for (std::size_t i = 0; i < p.state.size(); ++i)
      EXPECT_NEAR(p.state[i], q.state[i], tolerance * std::max(1.0, std::abs(p.state[i]))) << name;
  }
  for (const Largest& of : {position, velocity, stress, strain, volume})
    EXPECT_LE(of.difference, tolerance * std::max(of.value, 1e-3)) << name;
  const double energy = std::abs(engine.work.external) + engine.work.dissipated + std::abs(engine.work.walls);
  for (const auto part :
       {&mpm::Work::external, &mpm::Work::damped, &mpm::Work::dissipated, &mpm::Work::walls, &mpm::Work::mapping})
    EXPECT_NEAR(engine.work.*part, device.work.*part, tolerance * energy) << name;
  EXPECT_EQ(engine.lost.size(), device.lost.size()) << name;
  EXPECT_EQ(engine.step_count, device.step_count);
  EXPECT_NEAR(engine.monitor.kinetic_energy, device.monitor.kinetic_energy, tolerance * engine.monitor.kinetic_energy)
      << name;
  EXPECT_NEAR(engine.monitor.out_of_balance, device.monitor.out_of_balance, tolerance * engine.monitor.external)
      << name;
  EXPECT_NEAR(engine.monitor.speed, device.monitor.speed, tolerance * engine.monitor.speed) << name;
}

/// Steps a body here and on the device.
template <int D>
void compare(mpm::Body<D> body, const mpm::StepOptions<D>& options, const std::string& name, int steps,
             int fade_interval = 0) {
  mpm::gather_nodal_sums(body, options);
  mpm::Body<D> there = body;
  mpm::DeviceStepper<D> device(mpm::make_emulated_device<D>());
  for (int s = 0; s < steps; ++s) {
    mpm::step(body, options);
    device.step(there, options);
    if (fade_interval == 0 || s % fade_interval != 0) continue;
    mpm::fade_unseen(body, options);
    device.fade_unseen(there);
  }
  const mpm::CriticalStep here = mpm::find_critical_step(body, options.mass_scaling),
                          found = device.find_critical_step(there, options);
  EXPECT_NEAR(here.dt, found.dt, 1e-10 * here.dt);
  EXPECT_EQ(here.element, found.element);
  device.bring_back(there);
  expect_same(body, there, name);
  // What came back goes on here as if it had never been away.
  for (int s = 0; s < 10; ++s) {
    mpm::step(body, options);
    mpm::step(there, options);
  }
  expect_same(body, there, name + ", after the return");
}

template <int D>
void compare(const reference::Body<D>& plain, const Variant& v, int steps) {
  const mpm::Body<D> body = golden::translate(plain, 3);
  Vec<D> gravity;
  for (int d = 0; d < D; ++d) gravity[d] = plain.gravity[d];
  mpm::StepOptions<D> options = make_options(body, v, gravity);
  options.monitor = true;
  compare(body, options, v.name, steps, v.fade_interval);
}

TEST(DeviceAgainstEngine, PlaneSlopeIsTheSamePointByPoint) {
  for (const Variant& v : all_variants()) compare(set_in_motion(reference::make_slope<2>()), v, 100);
}

TEST(DeviceAgainstEngine, SpatialSlopeIsTheSamePointByPoint) {
  for (const Variant& v : all_variants()) compare(set_in_motion(reference::make_slope<3>()), v, 100);
}

}  // namespace
}  // namespace talus
