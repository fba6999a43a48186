// SPDX-License-Identifier: MIT
// Strips whose numbers other programs publish, on elastic soil and on soil whose stiffness or strength grows with
// depth. Definitions and numbers after the verification of katai2d, which quotes the PLAXIS 2D validation manual,
// version 8.

#include <gtest/gtest.h>

#include <cmath>

#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::WetBox;

/// Dry soil on a rigid rough base.
struct StripBox {
  WetBox box;
  StripBox(const std::vector<support::WetLayer>& layers, double width, mesh::Plan plan, double size)
      : box(layers, width, size, std::move(plan)) {
    box.solid.point_stress.clear();
    support::add_roller<2>(box.solid, 0, 0);
    box.solid.supports.back().sides = support::find_sides_at<2>(box.mesh, 1, 0);
    for (const auto& x : box.mesh.nodes) box.model.steady_head.push_back(x[1]);
    box.model.drainage = fem::StageDrainage::drained;
  }
  /// A smooth rigid strip of 2 m in the middle under this pressure.
  void press_strip(double pressure) {
    fem::Bar strip;
    strip.name = "strip";
    strip.head = {box.width / 2 - 1, box.height}, strip.end = {box.width / 2 + 1, box.height};
    strip.axial_stiffness = 1;
    strip.compressive = strip.tensile = fem::unlimited;
    strip.bending_stiffness = strip.shear_stiffness = 1e13;
    strip.bond_stiffness = 1e-3, strip.lateral_stiffness = 1e12;
    strip.line_load = {0, -pressure};
    box.solid.bars = {strip};
  }
  fem::ConsolidationResult<2> run(int steps = 1) const {
    fem::ConsolidationSchedule schedule;
    schedule.load_steps = steps;
    schedule.most_halvings = 4;
    schedule.threads = 1;
    return fem::run_stage(box.model, fem::make_first_state(box.model, box.model.steady_head), schedule);
  }
  double find_settlement(const fem::ConsolidationResult<2>& result, double x) const {
    return -result.outputs.back().at.solid.displacement[box.find_node(x, box.height)][1];
  }
};

/// The mesh has nodes at the edges of the strip and smaller elements there.
mesh::Plan make_strip_plan(double middle, double depth, double size) {
  mesh::Plan plan;
  plan.lines = {{"strip", {{middle - 1, depth}, {middle + 1, depth}}}};
  for (const double x : {middle - 1, middle + 1}) plan.refinements.push_back({{{x, depth}}, size / 4, 1});
  return plan;
}

TEST(ConsolidationPeers, SmoothRigidStripOnElasticSoil) {
  // G = 500 kPa, ν = 1/3: F = 2 (1 + ν) G B s/(2 · 0.88) after Giroud (1972) is 15.15 kN/m at s = 10 mm; PLAXIS
  // publishes 15.24, katai2d 15.32.
  StripBox soil({{4, 2e6, 1, 1.0 / 3}}, 14, make_strip_plan(7, 4, 0.25), 0.25);
  const double force = 15e3;
  soil.press_strip(force / 2);
  const auto result = soil.run();
  ASSERT_TRUE(result.converged);
  const double settlement = soil.find_settlement(result, 7), at_ten = force * 0.01 / settlement;
  EXPECT_NEAR(at_ten, 15.15e3, 0.01 * 15.15e3);
  EXPECT_NEAR(at_ten, 15.24e3, 0.01 * 15.24e3);
  EXPECT_NEAR(soil.find_settlement(result, 6.25), settlement, 1e-3 * settlement);
}

TEST(ConsolidationPeers, SmoothRigidStripOnClayThatStrengthensWithDepth) {
  // s_u = 1 kPa + 2 kPa/m z: 7.80 kPa after Davis and Booker (1973); PLAXIS publishes 7.86, katai2d 7.91.
  StripBox soil({{2, 1e6, 1, 0.3}}, 8, make_strip_plan(4, 2, 0.25), 0.25);
  soil.box.solid.make_law = [](int, double factor) -> material::Law {
    return material::Tresca(material::LinearElastic::from_young(299e3, 0.3), 1e3, factor);
  };
  soil.box.solid.set_state = [](int, const Vec<2>& x, double* state) { state[1] = 2e3 * (2 - x[1]); };
  const double load = 10e3;
  soil.press_strip(load);
  const auto result = soil.run(20);
  EXPECT_FALSE(result.converged);
  EXPECT_GT(result.reached * load, 7.80e3);
  EXPECT_LT(result.reached * load, 1.045 * 7.80e3);
}

TEST(ConsolidationPeers, FlexibleStripOnUndrainedSoilThatStiffensWithDepth) {
  // G = 100 kPa/m z, incompressible: q/(2 dG/dz) = 50 mm under the load and nothing beside it (Gibson 1967). The soil
  // is a half-space there; the ground of this box heaves by the volume that the load displaces.
  constexpr double depth = 60, rise = 100e3, load = 10e3, poisson = 0.3, settlement = load / (2 * rise);
  mesh::Plan plan;
  plan.lines = {{"strip", {{0, depth}, {1, depth}}}};
  plan.refinements.push_back({{{0, depth}, {3, depth}}, 0.05, 10});
  plan.refinements.push_back({{{0, depth}, {depth, depth}}, 0.2, 20});
  WetBox box({{depth, 1e6, 1e-9, poisson}}, depth, 2, plan);
  // Each element is a region with the stiffness at its middle.
  std::vector<double> young;
  for (std::size_t e = 0; e < box.mesh.elements.size(); ++e) {
    double z = 0;
    for (const int n : box.mesh.elements[e]) z += (depth - box.mesh.nodes[static_cast<std::size_t>(n)][1]) / 3;
    young.push_back(2 * (1 + poisson) * rise * z);
    box.mesh.element_region[e] = static_cast<int>(e);
  }
  box.mesh.region_names.assign(young.size(), "layer 0");
  box.flow.soils.assign(young.size(), fem::HydraulicSoil<2>{box.flow.soils[0]});
  box.solid.make_law = [&young](int region, double) -> material::Law {
    return material::LinearElastic::from_young(young[static_cast<std::size_t>(region)], poisson);
  };
  support::add_load<2>(
      box.solid,
      support::find_sides<2>(box.mesh, [](const Vec<2>& x) { return x[1] > depth - 1e-9 && x[0] < 1 + 1e-9; }),
      {0, -load});
  const auto state = box.press_undrained(box.make_start());
  const auto find_settlement = [&](double x) { return -state.solid.displacement[box.find_node(x, depth)][1]; };
  const double far = find_settlement(10);
  EXPECT_NEAR(far, -settlement / depth, 0.03 * settlement / depth);
  for (const double x : {0.0, 0.3, 0.6, 0.8}) EXPECT_NEAR(find_settlement(x) - far, settlement, 0.015 * settlement);
  for (const double x : {1.5, 2.0, 3.0}) EXPECT_NEAR(find_settlement(x), far, 0.01 * settlement);
}

}  // namespace
}  // namespace talus
