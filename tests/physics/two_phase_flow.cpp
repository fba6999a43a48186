// SPDX-License-Identifier: MIT
// Steady flow in the plain two-velocity step: Darcy's discharge through layers, and the effect of damping on it.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "physics/gravity.hpp"
#include "physics/wet_columns.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

/// Flow upwards through 1 m of a soil on 1 m of one ten times tighter and of another porosity, rigid skeleton, under a
/// fall of the head by 0.4 m, until it is steady.
struct LayeredFlow {
  WetBody<2> body;
  double into = 0, out = 0;  ///< discharges over Darcy's
  double jump = 0;           ///< head at the boundary of the layers above that at the top [m]
};

LayeredFlow run_layered_flow(double damping, DampedForce damped_force) {
  Soil loose = make_table_soil(1e-10), tight = make_table_soil(1e-11);
  loose.water.bulk_modulus = tight.water.bulk_modulus = 2.15e7;
  WetBody<2> body = make_layered_column(loose, tight, 0);
  WetSettings settings{.water_damping = damping, .damped_force = damped_force, .mass_scaling = 10, .frozen = true};
  settings.time_step = 0.9 * smallest_altitude(body.mesh) / std::sqrt(2.15e7 / 0.3 / 1000 * 1.3 / 10);
  for (int n = 0; n < 20000; ++n) step(body, settings);
  const WaterBudget before = body.budget;
  step(body, settings);
  const double discharge = 0.125 * 0.4 / (1 / loose.water.conductivity + 1 / tight.water.conductivity);
  LayeredFlow flow{body};
  flow.out = (body.budget.left - before.left) / (1000 * settings.time_step * discharge);
  flow.into = (body.budget.entered - before.entered) / (1000 * settings.time_step * discharge);
  flow.jump = 0.4 * tight.water.conductivity / (loose.water.conductivity + tight.water.conductivity);
  return flow;
}

TEST(TwoPhaseFlow, DischargeThroughLayersIsDarcysExactly) {
  const LayeredFlow flow = run_layered_flow(0, DampedForce::without_drag);
  EXPECT_NEAR(flow.into, 1, 1e-8);
  EXPECT_NEAR(flow.out, 1, 1e-8);
  for (const WetCell& cell : flow.body.cells) {  // head falls linearly in each layer
    double y = 0;
    for (std::size_t p : cell.points) y += flow.body.points[p].x[1] / 3;
    const double head = 2.1 + (y > 1 ? flow.jump * (2 - y) : flow.jump + (0.4 - flow.jump) * (1 - y));
    EXPECT_NEAR(flow.body.points[cell.points[0]].pressure, -gamma_w * (head - y), 1e-4);
  }
}

TEST(TwoPhaseFlow, DampingWithoutDragActsAsALowerConductivityAndNetDampingDoesNot) {
  EXPECT_NEAR(run_layered_flow(0.3, DampedForce::without_drag).out, 0.7, 1e-6);
  EXPECT_NEAR(run_layered_flow(0.3, DampedForce::net).out, 1, 1e-6);
}

}  // namespace
}  // namespace talus::reference
