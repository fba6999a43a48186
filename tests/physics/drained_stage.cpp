// SPDX-License-Identifier: MIT
// Stages with fixed pore pressures: the soil comes to rest under its buoyant weight, and stays at rest when the pore
// pressures are released.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "run/mpm/stage/auxiliary_body.hpp"
#include "support/points.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;
using input::WaterCondition;

constexpr double g = 9.81, water_weight = 1000 * g, soil_weight = (0.6 * 2650 + 0.4 * 1000) * g;

template <int D>
input::StepSettings hold_water() {
  return {.damping = 0.5,
          .smoothing = input::Smoothing::stable,
          .geometry = input::Geometry::frozen,
          .water = input::WaterMotion::held};
}

/// A column of 3 m with the water at `level` [m].
input::Case make_column_case(double level) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, level}};
  data.hydraulics = {make_hydraulic("top", WaterCondition::total_head, level)};
  return data;
}

mesh::Mesh<2> make_column_mesh() {
  return make_box_mesh<2>(
      {2, 12}, {0.5, 3}, {"soil"}, [](const Vec<2>&) { return 0; }, 0);
}

TEST(DrainedStage, EffectiveStressIsTheBuoyantWeight) {
  for (const double level : {2.0, 4.0}) {  // capillary water above the level; a metre of water on the ground
    const input::Case data = make_column_case(level);
    auto body = run::prepare<2>(data, make_column_mesh());
    EXPECT_EQ(run_plan(body, make_rest_stage(data, body, 20, hold_water<2>())), results::StageEnd::rest);
    for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      Vec<2> xi;
      xi.fill(1.0 / 3);
      const double y = mesh::to_global(body.mesh(), p.element, xi)[1];
      const double total = -soil_weight * (3 - y) - water_weight * std::max(0.0, level - 3);
      const double effective = total - water_weight * (y - level);
      // Constant stresses in triangles lie up to a third of an element beside those of the column.
      EXPECT_NEAR(p.stress[1], effective, soil_weight * 0.25 / 3) << "y = " << y << ", level " << level;
      EXPECT_NEAR(p.pressure, water_weight * (y - level), 1) << "held";
    });
  }
}

template <int D>
void expect_rest_when_let_go(const input::Case& data, const mesh::Mesh<D>& mesh) {
  auto body = run::prepare<D>(data, mesh);
  ASSERT_EQ(run_plan(body, make_rest_stage<D>(data, body, 20, hold_water<D>())), results::StageEnd::rest);
  input::StepSettings free = hold_water<D>();
  free.water = input::WaterMotion::flows;
  mpm::StepOptions<D> options = run::make_options(make_stage<D>(data, body, 1, free));
  options.gravity = run::find_gravity<D>(data.gravity);
  options.monitor = true;
  options.dt = 1e-6;
  mpm::gather_nodal_sums(body, options);
  mpm::step(body, options);
  EXPECT_GT(body.monitor.external, 0);
  EXPECT_LT(body.monitor.out_of_balance, 1e-4 * body.monitor.external)
      << "the constant load is what the pressures do by themselves";
}

TEST(DrainedStage, NothingMovesWhenTheWaterIsReleased) {
  expect_rest_when_let_go<2>(make_column_case(2), make_column_mesh());
  expect_rest_when_let_go<2>(make_column_case(4), make_column_mesh());
  input::Case step2 = make_box_case<2>(make_wet_soil()), step3 = make_box_case<3>(make_wet_soil());
  for (input::Case* data : {&step2, &step3}) {
    data->hydraulics = {make_hydraulic("foot", WaterCondition::total_head, 1.5)};
    data->initial.water.pressure = input::InitialPressure::water_table;
    data->initial.water.water_table = {{0, 1.5}};
  }
  expect_rest_when_let_go<2>(step2, make_step_mesh<2>());
  expect_rest_when_let_go<3>(step3, make_step_mesh<3>());
}

TEST(DrainedStage, WaterGrowsWithTheWeightOnARamp) {
  // Half of both on the way is half of the stress: nothing is pushed up first.
  const input::Case data = make_column_case(4);
  auto body = run::prepare<2>(data, make_column_mesh());
  auto plan = make_stage(data, body, 4, hold_water<2>());
  plan.gravity_ramp = 4;
  run::StageState state;
  double highest = 0, halfway = 0;
  run::StageHooks<2> hooks;
  hooks.look = [&](const mpm::Body<2>& b, const run::StageState&) {
    double lowest = 0;
    for_each_point(b, [&](int, const mpm::PointView<2>& p) {
      highest = std::max(highest, p.displacement[1]);
      lowest = std::min(lowest, p.displacement[1]);
    });
    if (b.time < 2) halfway = lowest;
  };
  run::run_stage(body, plan, state, hooks);
  const double end = -mpm::find_largest_displacement(body).value;
  EXPECT_LT(highest, 1e-2 * std::abs(end));
  EXPECT_NEAR(halfway, 0.5 * end, 0.1 * std::abs(end));
}

TEST(DrainedStage, NeedsFrozenGeometry) {
  const input::Case data = make_column_case(2);
  auto body = run::prepare<2>(data, make_column_mesh());
  input::StepSettings moving = hold_water<2>();
  moving.geometry = input::Geometry::moving;
  EXPECT_THROW(run_plan(body, make_stage(data, body, 1, moving)), Error);
}

}  // namespace
}  // namespace talus
