// SPDX-License-Identifier: MIT
// The GPU kernels, emulated on the processor, equal the MPM step to round-off at every point, for every option and
// dimension. Only the launch is specific to the GPU.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "base/error.hpp"
#include "golden/device_comparison.hpp"
#include "golden/plain_translation.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/solver/step.hpp"
#include "mpm/state/node_rows.hpp"
#include "support/clay_block.hpp"

namespace talus {
namespace {

using namespace golden;

template <int D>
mpm::StepOptions<D> make_options(const mpm::Body<D>& body, const PlainVariant& v,
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

template <int D>
void compare(const reference::Body<D>& plain, const PlainVariant& v, int steps) {
  const mpm::Body<D> body = golden::translate(plain, 3);
  Vec<D> gravity;
  for (int d = 0; d < D; ++d) gravity[d] = plain.gravity[d];
  mpm::StepOptions<D> options = make_options(body, v, gravity);
  options.monitor = true;
  compare_on_device(body, options, v.name, steps, v.filter_interval);
}

/// Returns the body of the device after `steps`, copied back.
template <int D>
mpm::Body<D> run_on_device(mpm::Body<D> body, const mpm::StepOptions<D>& options, int steps,
                           const mpm::Emulation& how) {
  mpm::gather_nodal_sums(body, options);
  mpm::DeviceStepper<D> device(make_tested_device<D>(how));
  for (int s = 0; s < steps; ++s) device.step(body, options);
  device.filter_null_modes(body);
  device.copy_back(body);
  return body;
}

/// A slope in whose blocks two soils lie.
reference::Body<2> make_mixed_slope() {
  auto plain = set_in_motion(reference::make_slope<2>());
  reference::Material other = plain.materials[0];
  other.plastic = false;
  other.young_modulus *= 2;
  plain.materials.push_back(other);
  for (auto& p : plain.points) p.material = std::sin(3 * p.x[0]) > 0.5 ? 1 : 0;
  return plain;
}

/// Through many elements.
reference::Body<2> make_landslide() {
  auto plain = reference::make_slope<2>();
  for (auto& p : plain.points) p.v[0] = 4 * p.x[1];
  return plain;
}
const PlainVariant fast_variant = {"fast", true, reference::Smoothing::none, true, false, 1};

TEST(DeviceAgainstEngine, PlaneSlopeIsTheSamePointByPoint) {
  for (const PlainVariant& v : all_variants()) compare(set_in_motion(reference::make_slope<2>()), v, 100);
}

TEST(DeviceAgainstEngine, SpatialSlopeIsTheSamePointByPoint) {
  for (const PlainVariant& v : all_variants()) compare(set_in_motion(reference::make_slope<3>()), v, 100);
}

TEST(DeviceAgainstEngine, TwoMaterialsInOneElementAreTheSame) {
  for (const PlainVariant& v : all_variants()) compare(make_mixed_slope(), v, 100);
}

TEST(DeviceAgainstEngine, SandThatComesApartAndIsPressedAgainIsTheSame) {
  for (const PlainVariant& v : all_variants()) {
    auto plain = reference::make_slope<2>();
    plain.materials[0].cohesion = plain.materials[0].tensile_strength = 0;
    plain.gravity *= 20;
    for (auto& p : plain.points) p.v[1] = 2 * p.x[1];
    compare(plain, v, 150);
  }
}

TEST(DeviceAgainstEngine, WallThatIsPushedInIsTheSame) {
  auto plane = reference::make_slope<2>();
  auto spatial = reference::make_slope<3>();
  reference::push_left_wall(plane.mesh, plane.constraints);
  reference::push_left_wall(spatial.mesh, spatial.constraints);
  for (const PlainVariant& v : all_variants()) {
    compare(plane, v, 100);
    compare(spatial, v, 40);
  }
}

TEST(DeviceAgainstEngine, LandslideThroughManyElementsOverfillsBlocksAndIsTheSame) {
  compare(make_landslide(), fast_variant, 250);
}

/// The result does not depend on the number of threads of a block that run together.
TEST(DeviceAgainstEngine, OrderOfThreadsChangesNoBit) {
  const mpm::Body<2> body = golden::translate(make_mixed_slope(), 3);
  for (const PlainVariant& v : all_variants()) {
    const mpm::StepOptions<2> options = make_options(body, v, {0, -9.81});
    const mpm::Body<2> forwards = run_on_device(body, options, 60, {}),
                       backwards = run_on_device(body, options, 60, {.backwards = true}),
                       together = run_on_device(body, options, 60, {.threads = 2, .block = 1});
    for (const mpm::Body<2>* other : {&backwards, &together}) {
      EXPECT_EQ(forwards.points.data, other->points.data) << v.name;
      EXPECT_EQ(forwards.points.id, other->points.id) << v.name;
      EXPECT_EQ(forwards.nodes.sums, other->nodes.sums) << v.name;
      EXPECT_EQ(forwards.work.mapping, other->work.mapping) << v.name;
    }
  }
}

TEST(DeviceAgainstEngine, FrictionalWallsTractionsAndDampingAreTheSame) {
  auto plain = set_in_motion(reference::make_slope<3>());
  mpm::Body<3> body = golden::translate(plain, 3);
  mpm::Load<3> on_points{true, {}, {}}, on_nodes{false, {}, {}};
  for (int i = 0; i < 20; ++i) on_points.entries.push_back({3 * i, {200, -100, 0}});
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (i % 7 == 0) on_nodes.entries.push_back({static_cast<int>(i), {0, -30, 10}});
    if (body.mesh().nodes[i][1] > 1e-9) continue;
    mpm::Constraint<3>& floor = support::get_constraint(body, i);
    floor = {};
    floor.has_wall = true;
    floor.wall_normal = {0, -1, 0};
    floor.friction = 0.3;
  }
  body.conditions.loads = {on_points, on_nodes};
  mpm::StepOptions<3> options = make_options(body, all_variants()[3], {0, -9.81, 0});
  options.monitor = true;
  // Not at rest, where the sign of a velocity is round-off.
  options.damping = 0.02;
  compare_on_device(body, options, "walls", 100);
}

TEST(DeviceAgainstEngine, ClayThatSoftensOverALengthIsTheSame) {
  for (const bool moving : {false, true}) {
    mpm::Body<2> body = support::make_clay_block<2>(6, 0.3);
    mpm::StepOptions<2> options = support::make_block_options(body);
    options.moving = moving;
    options.damping = 0;
    options.monitor = true;
    compare_on_device(body, options, moving ? "moving clay" : "clay", 100);
  }
}

TEST(DeviceAgainstEngine, DeviceWhoseMemoryRunsOutOnTheWaySaysHowToGoOn) {
  mpm::Body<2> body = golden::translate(make_landslide(), 3);
  const mpm::StepOptions<2> options = make_options(body, fast_variant, {0, -9.81});
  mpm::gather_nodal_sums(body, options);
  bool steps = false;
  for (std::size_t memory = 100'000; !steps; memory += 4'000) {  // the least with which a step is done
    mpm::DeviceStepper<2> device(mpm::make_emulated_device<2>({.memory = memory}));
    try {
      device.step(body, options);
    } catch (const Error&) {
      continue;
    }
    steps = true;
    try {
      for (int n = 0; n < 2000; ++n) device.step(body, options);
      FAIL() << "there is no room for blocks that grow";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::no_memory);
      EXPECT_NE(std::string(error.what()).find("--resume"), std::string::npos) << error.what();
    }
  }
  mpm::make_emulated_device<2>({});  // all memory again
}

TEST(DeviceAgainstEngine, KernelsThatAreTimedSayWhatTheyAre) {
  mpm::Body<2> body = golden::translate(reference::make_slope<2>(), 3);
  const mpm::StepOptions<2> options = make_options(body, all_variants()[0], {0, -9.81});
  mpm::gather_nodal_sums(body, options);
  mpm::DeviceStepper<2> device(make_tested_device<2>({}));
  device.step(body, options);
  EXPECT_TRUE(device.list_times().empty());
  device.time_kernels();
  for (int s = 0; s < 3; ++s) device.step(body, options);
  std::map<std::string, int> launches;
  for (const mpm::KernelTime& time : device.list_times()) {
    EXPECT_GT(time.seconds, 0) << time.name;
    launches[time.name] = time.launches;
  }
  for (const char* name : {"AdvanceElement", "SolveNode", "RemapNode", "Scan"}) EXPECT_EQ(launches[name], 3) << name;
  EXPECT_EQ(launches["sum of Listed"], 6);
}

/// Wherever it is among the nodes: an unstable run must not look calm.
TEST(DeviceAgainstEngine, WhatIsNoNumberWinsAmongSpeedsAndSteps) {
  mpm::PieceSums all;
  all.note_speed(NAN, 7);
  all.add({});
  all.note_speed(1, 8);
  EXPECT_TRUE(std::isnan(all.speed2));
  EXPECT_EQ(all.fastest, 7);
  mpm::StepSquare least;
  least.add({1, 3});
  least.add({NAN, 4});
  least.add({0.5, 5});
  least.add({});
  EXPECT_TRUE(std::isnan(least.dt2));
  EXPECT_EQ(least.element, 4);
}

TEST(DeviceAgainstEngine, PointTurnedInsideOutLeavesNoStep) {
  mpm::Body<2> body = golden::translate(reference::make_slope<2>(), 3);
  const mpm::StepOptions<2> options = make_options(body, all_variants()[0], {0, -9.81});
  EXPECT_GT(mpm::find_critical_step(body, options).dt, 0);
  const std::int64_t place = body.points.place[7];
  double* p = body.points.slot(place / lane_width) + place % lane_width;
  p[mpm::Points<2>::volume * lane_width] *= -1;
  EXPECT_TRUE(std::isnan(mpm::find_critical_step(body, options).dt));
}

TEST(DeviceAgainstEngine, DeviceWithoutRoomSaysWhatWouldFit) {
  mpm::Body<2> body = golden::translate(reference::make_slope<2>(), 3);
  const mpm::StepOptions<2> options = make_options(body, all_variants()[0], {0, -9.81});
  mpm::gather_nodal_sums(body, options);
  mpm::DeviceStepper<2> device(mpm::make_emulated_device<2>({.memory = 100'000}));
  try {
    device.step(body, options);
    FAIL() << "there is no room";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::no_memory);
    EXPECT_NE(std::string(error.what()).find("would fit"), std::string::npos) << error.what();
  }
  mpm::make_emulated_device<2>({});  // all memory again
}

}  // namespace
}  // namespace talus
