// SPDX-License-Identifier: MIT
// Equalised-mass bodies at frozen geometry: small elements no longer reduce the time step, and the state of rest is the
// same.

#include "mpm/state/body.hpp"
#include "run/mpm/stage/auxiliary_body.hpp"

#include <gtest/gtest.h>

#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;

mesh::Plan plan_step(double finer) {
  mesh::Plan plan;
  plan.box_max = {4, 3};
  plan.size = 0.25;
  plan.polygons = {{"soil", {{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 2}, {0, 2}}}};
  return mesh::refine_corners(plan, finer, 4);
}

input::StepSettings freeze() {
  return {.damping = 0.5,
          .smoothing = input::Smoothing::stable,
          .geometry = input::Geometry::frozen,
          .objective_rate = false,  // rotated stresses remember the way
          .water = input::WaterMotion::held};
}

/// Expects the same state of rest with and without equalised mass.
void expect_same_rest(const input::Case& data, const mesh::Mesh<2>& mesh) {
  const auto rest = [&](bool evens) {
    auto body = run::prepare<2>(data, mesh);
    auto plan = make_rest_stage(data, body, 60, freeze(), 1e-11);
    plan.gravity_ramp = 0.5;
    plan.equalises_mass = evens;
    EXPECT_EQ(run_plan(body, plan), results::StageEnd::rest);
    return body;
  };
  const auto plain = rest(false), even = rest(true);
  EXPECT_LT(10 * even.step_count, 4 * plain.step_count);
  const double largest = mpm::find_largest_displacement(plain).value;
  for (int id = 0; id < plain.points.size(); ++id) {
    const auto a = mpm::view_point(plain, id), b = mpm::view_point(even, id);
    EXPECT_EQ(a.mass, b.mass) << "what was added is gone";
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(a.displacement[d], b.displacement[d], 1e-8 * largest);
  }
  ASSERT_EQ(plain.nodes.load.size(), even.nodes.load.size());
  for (std::size_t i = 0; i < plain.nodes.load.size(); ++i) EXPECT_EQ(plain.nodes.load[i], even.nodes.load[i]);
}

TEST(EqualisedMass, LeavesTheRestAsItIs) {
  expect_same_rest(make_box_case<2>(make_elastic()), mesh::generate<2>(plan_step(4)));
}

TEST(EqualisedMass, KeepsTheStateOfRestWithDrainedWater) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, 1}};
  data.hydraulics = {make_hydraulic("right", input::WaterCondition::total_head, 1)};
  expect_same_rest(data, mesh::generate<2>(plan_step(4)));
}

TEST(EqualisedMass, TheStepIsThatOfOrdinaryElements) {
  const input::Case data = make_box_case<2>(make_elastic());
  const auto find_step = [&](double finer, bool evens) {
    auto body = run::prepare<2>(data, mesh::generate<2>(plan_step(finer)));
    auto plan = make_rest_stage(data, body, 1, freeze());
    plan.equalises_mass = evens;
    return run::find_critical_step(body, plan).dt;
  };
  const double ordinary = find_step(1, false);
  EXPECT_LT(find_step(4, false), 0.35 * ordinary);
  EXPECT_GT(find_step(4, true), 0.85 * ordinary);
}

/// The weight on every node is that of the soil: mass times gravity, and the load that takes the rest away.
TEST(EqualisedMass, TheWeightIsThatOfTheSoil) {
  const input::Case data = make_box_case<2>(make_elastic());
  auto body = run::prepare<2>(data, mesh::generate<2>(plan_step(4)));
  auto plan = make_rest_stage(data, body, 1, freeze());
  auto even = run::make_even_body(body, plan, {});
  const auto sum = [&](mpm::Body<2>& b) {
    const auto options = run::make_options(plan);
    mpm::gather_nodal_sums(b, options);
    mpm::gather_loads(b);
    std::vector<Vec<2>> weight(b.mesh().nodes.size());
    for (std::size_t i = 0; i < weight.size(); ++i) {
      double mass = 0;
      for (int k = b.layout->row_start[i]; k < b.layout->row_start[i + 1]; ++k)
        mass += b.nodes.sums[static_cast<std::size_t>(b.layout->node_rows[k]) * mpm::sums_stride];
      for (int d = 0; d < 2; ++d)
        weight[i][d] = mass * plan.gravity[d] + (b.nodes.load.empty() ? 0.0 : b.nodes.load[i][d]);
    }
    return weight;
  };
  const auto before = sum(body), after = sum(even);
  for (std::size_t i = 0; i < before.size(); ++i)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(after[i][d], before[i][d], 1e-9 * std::abs(body.smallest_mass * 9.81)) << i;
}

}  // namespace
}  // namespace talus
