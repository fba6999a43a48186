// SPDX-License-Identifier: MIT
#pragma once
// Runs a body on the processor and on a device, and compares them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "golden/tested_device.hpp"
#include "mpm/backend/emulated.hpp"
#include "mpm/solver/device_stepper.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"

namespace talus::golden {

/// `share` of the largest value of a field.
struct Largest {
  double difference = 0, value = 0;
  void add(double a, double b) {
    difference = std::max(difference, std::abs(a - b));
    value = std::max(value, std::abs(a));
  }
};

/// Expects equal water of points and nodes, and equal budgets, to 1e-10 of the largest value.
template <int D>
void expect_same_water(const mpm::Body<D>& engine, const mpm::Body<D>& device, const std::string& name) {
  constexpr double tolerance = 1e-10;
  Largest pressure, mass, velocity, of_nodes, own, budget;
  for (int id = 0; id < engine.points.size(); ++id) {
    if (!mpm::is_present(engine, id)) continue;
    const auto p = mpm::view_point(engine, id), q = mpm::view_point(device, id);
    pressure.add(p.pressure, q.pressure);
    mass.add(p.water_mass, q.water_mass);
    for (std::size_t d = 0; d < D; ++d) velocity.add(p.water_velocity[d], q.water_velocity[d]);
  }
  const mpm::DarcyWater<D>&m = engine.water.darcy, &n = device.water.darcy;
  ASSERT_EQ(m.pressure.size(), n.pressure.size());
  for (std::size_t i = 0; i < m.pressure.size(); ++i) {
    ASSERT_EQ(std::isnan(m.pressure[i]), std::isnan(n.pressure[i])) << name << ", node " << i;
    if (!std::isnan(m.pressure[i])) of_nodes.add(m.pressure[i], n.pressure[i]);
    own.add(m.own[i], n.own[i]);
  }
  EXPECT_EQ(m.ponded, n.ponded) << name;
  EXPECT_EQ(m.rounds, n.rounds) << name;
  EXPECT_NEAR(m.iterations, n.iterations, 2 * m.rounds) << name;  // round-off may decide which one is near enough
  for (std::size_t i = 0; i < engine.water.budgets.size(); ++i)
    for (const auto part : {&mpm::SurfaceBudget::entered, &mpm::SurfaceBudget::left, &mpm::SurfaceBudget::supplied,
                            &mpm::SurfaceBudget::runoff})
      budget.add(engine.water.budgets[i].*part, device.water.budgets[i].*part);
  budget.add(engine.water.transpired, device.water.transpired);
  budget.add(engine.water.pressed_in, device.water.pressed_in);
  budget.add(engine.water.left_grid, device.water.left_grid);
  for (const Largest& of : {pressure, mass, velocity, of_nodes, own, budget})
    EXPECT_LE(of.difference, tolerance * of.value) << name;
  const double energy = std::abs(engine.work.external) + std::abs(engine.work.pore_water);
  EXPECT_NEAR(engine.work.pore_water, device.work.pore_water, tolerance * energy) << name;
}

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
  if (engine.water.is_wet()) expect_same_water(engine, device, name);
  EXPECT_EQ(engine.step_count, device.step_count);
  EXPECT_NEAR(engine.monitor.kinetic_energy, device.monitor.kinetic_energy, tolerance * engine.monitor.kinetic_energy)
      << name;
  EXPECT_NEAR(engine.monitor.out_of_balance, device.monitor.out_of_balance, tolerance * engine.monitor.external)
      << name;
  EXPECT_NEAR(engine.monitor.speed, device.monitor.speed, tolerance * engine.monitor.speed) << name;
}

/// The quantities of a row of a history.
template <int D>
void expect_same_observation(const mpm::Observation<D>& engine, const mpm::Observation<D>& device,
                             const std::string& name) {
  constexpr double tolerance = 1e-10;
  const mpm::Totals<D>&t = engine.totals, &u = device.totals;
  EXPECT_EQ(t.points, u.points) << name;
  for (const auto part : {&mpm::Totals<D>::mass, &mpm::Totals<D>::water, &mpm::Totals<D>::kinetic,
                          &mpm::Totals<D>::potential, &mpm::Totals<D>::elastic})
    EXPECT_NEAR(t.*part, u.*part, tolerance * std::abs(t.*part)) << name;
  for (std::size_t d = 0; d < D; ++d) EXPECT_NEAR(t.centre[d], u.centre[d], tolerance * norm(t.centre)) << name;
  for (const auto part : {&mpm::WaterState<D>::mass, &mpm::WaterState<D>::largest_suction})
    EXPECT_NEAR(engine.water.*part, device.water.*part, tolerance * std::abs(engine.water.*part)) << name;
  if (engine.water.mass > 0) {
    EXPECT_NEAR(engine.water.largest_pressure, device.water.largest_pressure,
                tolerance * std::abs(engine.water.largest_pressure))
        << name;
  }
  EXPECT_NEAR(engine.largest_displacement, device.largest_displacement, tolerance * engine.largest_displacement + 1e-14)
      << name;
  ASSERT_EQ(engine.points.size(), device.points.size());
  for (std::size_t i = 0; i < engine.points.size(); ++i) {
    EXPECT_EQ(engine.points[i].element, device.points[i].element) << name;
    for (std::size_t d = 0; d < D; ++d)
      EXPECT_NEAR(engine.points[i].position[d], device.points[i].position[d], 1e-10) << name;
  }
}

/// ThreadSanitizer (PRESET=tsan) sees neighbouring threads of a kernel run together, in all comparisons.
inline mpm::Emulation choose_emulation() {
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
  return {.threads = 2, .block = 1};
#endif
#endif
  return {};
}

/// Steps a body here and on the device.
template <int D>
void compare_on_device(mpm::Body<D> body, const mpm::StepOptions<D>& options, const std::string& name, int steps,
                       int filter_interval = 0) {
  mpm::gather_nodal_sums(body, options);
  mpm::Body<D> there = body;
  mpm::DeviceStepper<D> device(make_tested_device<D>(choose_emulation()));
  for (int s = 0; s < steps; ++s) {
    mpm::step(body, options);
    device.step(there, options);
    if (filter_interval == 0 || s % filter_interval != 0) continue;
    mpm::filter_null_modes(body, options);
    device.filter_null_modes(there);
  }
  const mpm::CriticalStep here = mpm::find_critical_step(body, options),
                          found = device.find_critical_step(there, options);
  EXPECT_NEAR(here.dt, found.dt, 1e-10 * here.dt);
  EXPECT_EQ(here.element, found.element);
  expect_same_observation(mpm::observe(body, options.gravity, {0, 1}), device.observe(there, options.gravity, {0, 1}),
                          name);
  device.copy_back(there);
  expect_same(body, there, name);
  // The body that was copied back continues on the processor as if it had never left.
  for (int s = 0; s < 10; ++s) {
    mpm::step(body, options);
    mpm::step(there, options);
  }
  expect_same(body, there, name + ", after the return");
}

}  // namespace talus::golden
