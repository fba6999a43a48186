// SPDX-License-Identifier: MIT
// A wet body that is saved, read and continued is bitwise identical to an uninterrupted one, with rain, ponded water,
// and pore pressures that are computed or fixed.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "output/files/archive.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "support/points.hpp"
#include "support/scratch.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;
using input::WaterCondition;

template <int D>
input::Case make_rained_step() {
  input::Case data = make_box_case<D>(make_wet_soil(5e6));
  input::PoreWater& water = data.materials["soil"].water;
  water.retention = input::RetentionCurve::exponential;
  water.minimum_saturation = 0.1;
  water.decay = 1 / 15e3;
  data.water.bulk_modulus = 2e8;
  data.hydraulics = {make_hydraulic("crest", WaterCondition::rain, 2e-4),
                     make_hydraulic("foot", WaterCondition::total_head, 1.3)};
  data.initial.stress = input::InitialStress::k0;
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, 1.3}};
  return data;
}

/// Runs a stage, and the same interrupted and resumed by way of a file.
template <int D>
void compare(input::StepSettings step, double duration) {
  constexpr std::int64_t steps = 2 * run::look_interval;
  const input::Case data = make_rained_step<D>();
  const mesh::Mesh<D> mesh = make_step_mesh<D>();
  mpm::Body<D> whole = run::prepare<D>(data, mesh);
  const run::StagePlan<D> plan = make_stage<D>(data, whole, duration, step);
  run_plan(whole, plan);
  struct Interruption {};
  const std::filesystem::path file = support::name_scratch("body.h5");
  {
    mpm::Body<D> body = run::prepare<D>(data, mesh);
    run::StageState state;
    run::StageHooks<D> hooks;
    hooks.look = [&](const mpm::Body<D>& b, const run::StageState& s) {
      if (s.steps < steps) return;
      output::ArchiveWriter archive;
      run::put_body(archive, b);
      run::put_stage(archive, s);
      archive.write(file);
      throw Interruption();
    };
    EXPECT_THROW(run::run_stage(body, plan, state, hooks), Interruption) << "the stage must be longer";
  }
  mpm::Body<D> resumed = run::prepare<D>(data, mesh);
  const output::ArchiveReader archive(file);
  run::get_body(archive, resumed);
  run::StageState state = run::get_stage(archive);
  run::run_stage(resumed, plan, state);

  EXPECT_EQ(whole.step_count, resumed.step_count);
  ASSERT_EQ(whole.points.data.size(), resumed.points.data.size());
  for_each_point(whole, [&](int id, const mpm::PointView<D>& p) {
    const auto q = mpm::view_point(resumed, id);
    EXPECT_EQ(p.position, q.position);
    EXPECT_EQ(p.velocity, q.velocity);
    EXPECT_EQ(p.stress, q.stress);
    EXPECT_EQ(p.pressure, q.pressure);
    EXPECT_EQ(p.water_mass, q.water_mass);
    EXPECT_EQ(p.water_velocity, q.water_velocity);
  });
  ASSERT_EQ(whole.water.budgets.size(), resumed.water.budgets.size());
  for (std::size_t i = 0; i < whole.water.budgets.size(); ++i) {
    EXPECT_EQ(whole.water.budgets[i].entered, resumed.water.budgets[i].entered);
    EXPECT_EQ(whole.water.budgets[i].left, resumed.water.budgets[i].left);
    EXPECT_EQ(whole.water.budgets[i].runoff, resumed.water.budgets[i].runoff);
  }
  EXPECT_EQ(whole.water.lost_between, resumed.water.lost_between);
  EXPECT_EQ(whole.work.external, resumed.work.external);
}

TEST(WetCheckpoint, MovingSoilResumesBitwiseIdentical) {
  compare<2>({.damping = 0.05,
              .smoothing = input::Smoothing::strain,
              .water = input::WaterMotion::flows,
              .pressure_smoothing = true},
             0.15);
  compare<3>({.damping = 0.05, .water = input::WaterMotion::flows}, 0.1);
}

TEST(WetCheckpoint, DarcyWaterResumesBitwiseIdentical) {
  const input::StepSettings settings{.damping = 0.05, .smoothing = input::Smoothing::stable, .courant = 0.3};
  compare<2>(settings, 0.6);
  compare<3>(settings, 0.6);
}

/// The Darcy step stores the pressure of the pool in the nodal loads, the two-velocity step stores it separately: it
/// must act once, whatever step ran before.
TEST(WetCheckpoint, ThePoolPressesOnceAfterTheDarcyFormulation) {
  const input::Case data = make_rained_step<2>();
  mpm::Body<2> one = run::prepare<2>(data, make_step_mesh<2>());
  run_plan(one, make_stage<2>(data, one, 0.1, {.damping = 0.05}));
  EXPECT_FALSE(one.nodes.load.empty()) << "nothing to count twice";
  mpm::Body<2> other = one;
  other.nodes.load.clear();
  for (mpm::Body<2>* body : {&one, &other})
    run_plan(*body, make_stage<2>(data, *body, 0.02, {.damping = 0.05, .water = input::WaterMotion::flows}));
  for_each_point(one, [&](int id, const mpm::PointView<2>& p) {
    EXPECT_EQ(p.velocity, mpm::view_point(other, id).velocity);
    EXPECT_EQ(p.stress, mpm::view_point(other, id).stress);
  });
}

TEST(WetCheckpoint, DrainedWaterResumesBitwiseIdentical) {
  compare<2>({.damping = 0.2,
              .smoothing = input::Smoothing::stable,
              .geometry = input::Geometry::frozen,
              .courant = 0.2,
              .water = input::WaterMotion::held},
             0.5);
}

}  // namespace
}  // namespace talus
