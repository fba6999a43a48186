// SPDX-License-Identifier: MIT
// Results are bitwise identical if a body is gathered and scattered again within a stage, as in a rebalance of the
// ranks.

#include <gtest/gtest.h>

#include "base/ranks.hpp"
#include "mpm/solver/build.hpp"
#include "mpm/state/partition.hpp"
#include "support/points.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;
using input::WaterCondition;

input::Case make_bank(bool wet) {
  input::Case data = make_box_case<2>(make_wet_soil(5e6));
  data.water.bulk_modulus = 2e8;
  data.initial.stress = input::InitialStress::k0;
  if (!wet) {
    data.materials["soil"].water = {};
    return data;
  }
  data.hydraulics = {make_hydraulic("crest", WaterCondition::rain, 2e-4),
                     make_hydraulic("foot", WaterCondition::total_head, 1.3)};
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, 1.3}};
  return data;
}

void compare(bool wet, const input::StepSettings& step) {
  const input::Case data = make_bank(wet);
  mpm::Body<2> plain = run::prepare<2>(data, make_step_mesh<2>());
  const run::StagePlan<2> plan = make_stage<2>(data, plain, 1, step);
  mpm::Body<2> whole = plain;
  run_plan(plain, plan);

  const auto scatter = [&] {
    return mpm::scatter_body(&whole, mpm::copy_description(whole), get_ranks(), {0, whole.layout->chunks});
  };
  mpm::Body<2> part = scatter();
  int rebalances = 0;
  run::StageState state;
  run::StageHooks<2> hooks;
  hooks.rebalance = [&](mpm::Body<2>& body) {
    mpm::collect(body, true, &whole);
    body = scatter();
    ++rebalances;
  };
  run::run_stage(part, plan, state, hooks);
  mpm::collect(part, true, &whole);
  EXPECT_GT(rebalances, 2);
  for_each_point(plain, [&](int id, const mpm::PointView<2>& p) {
    const auto q = mpm::view_point(whole, id);
    EXPECT_EQ(p.position, q.position);
    EXPECT_EQ(p.velocity, q.velocity);
    EXPECT_EQ(p.stress, q.stress);
    EXPECT_EQ(p.pressure, q.pressure);
    EXPECT_EQ(p.water_mass, q.water_mass);
  });
  EXPECT_EQ(plain.work.external, whole.work.external);
  EXPECT_EQ(plain.work.mapping, whole.work.mapping);
  ASSERT_EQ(plain.water.budgets.size(), whole.water.budgets.size());
  for (std::size_t i = 0; i < plain.water.budgets.size(); ++i)
    EXPECT_EQ(plain.water.budgets[i].entered, whole.water.budgets[i].entered);
}

TEST(Rebalance, OfDrySoilIsBitwiseIdentical) {
  compare(false, {.damping = 0.05, .smoothing = input::Smoothing::stable});
}
TEST(Rebalance, OfTheDarcyFormulationIsBitwiseIdentical) {
  compare(true, {.damping = 0.05, .smoothing = input::Smoothing::stable});
}
TEST(Rebalance, OfTheTwoVelocityFormulationIsBitwiseIdentical) {
  compare(true, {.damping = 0.05, .water = input::WaterMotion::flows});
}

}  // namespace
}  // namespace talus
