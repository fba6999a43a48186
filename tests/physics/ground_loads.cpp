// SPDX-License-Identifier: MIT
// Surcharges, r_u, a water table without pore water of its own, ponded water, and cohesion that grows with depth in MPM
// as in LEM and FEM: columns of 3 m against closed forms.

#include <gtest/gtest.h>

#include "mpm/solver/observe.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;

constexpr double g = 9.81, dry_weight = 1800 * g, water_weight = 1000 * g, depth = 3;

input::StepSettings hold() {
  return {.damping = 0.5, .smoothing = input::Smoothing::stable, .geometry = input::Geometry::frozen};
}

mesh::Mesh<2> make_column_mesh() {
  return make_box_mesh<2>(
      {2, 12}, {0.5, depth}, {"soil"}, [](const Vec<2>&) { return 0; }, 0);
}

/// The column at rest; `expected` gives the vertical effective stress at a level [Pa].
void expect_stress(const input::Case& data, const std::function<double(double)>& expected, const std::string& what) {
  auto body = run::prepare<2>(data, make_column_mesh());
  ASSERT_EQ(run_plan(body, make_rest_stage(data, body, 20, hold())), results::StageEnd::rest) << what;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto p = mpm::view_point(body, id);
    Vec<2> middle;
    middle.fill(1.0 / 3);
    const double y = mesh::to_global(body.mesh(), p.element, middle)[1];
    // Constant stresses in triangles lie up to a third of an element beside those of the column.
    EXPECT_NEAR(p.stress[1], expected(y), dry_weight * 0.25 / 3 + 1) << what << ", y = " << y;
  }
}

input::Case make_frozen_case() {
  input::Case data = make_box_case<2>(make_elastic());
  data.stages.resize(1);
  data.stages[0].step.geometry = input::Geometry::frozen;
  return data;
}

TEST(GroundLoads, ASurchargeAddsItsLoad) {
  input::Case data = make_frozen_case();
  data.surcharges = {{"road", {-1, 2}, {30e3, 30e3}, false}};
  for (const input::InitialStress stress : {input::InitialStress::none, input::InitialStress::k0}) {
    data.initial.stress = stress;
    data.initial.k0 = 0.4;
    expect_stress(
        data, [](double y) { return -dry_weight * (depth - y) - 30e3; }, "at rest");
  }
}

TEST(GroundLoads, PointsThatCarryTheLoadCarryTheSameForce) {
  input::Case data = make_frozen_case();
  data.surcharges = {{"road", {0.1, 0.4}, {20e3, 40e3}, false}};
  const auto sum = [&](input::Geometry geometry) {
    data.stages[0].step.geometry = geometry;
    const auto body = run::prepare<2>(data, make_column_mesh());
    double force = 0;
    for (const auto& load : body.conditions.loads) {
      EXPECT_EQ(load.on_points, geometry == input::Geometry::moving);
      for (const auto& entry : load.entries) force += entry.force[1];
    }
    return force;
  };
  EXPECT_NEAR(sum(input::Geometry::frozen), -0.3 * 30e3, 0.02 * 9e3) << "64 parts a side";
  EXPECT_NEAR(sum(input::Geometry::moving), sum(input::Geometry::frozen), 1e-6);
}

TEST(GroundLoads, PressureRatioCarriesItsFractionOfTheWeight) {
  input::Case data = make_frozen_case();
  data.materials["soil"].slices.pore_pressure_ratio = 0.3;
  for (const input::InitialStress stress : {input::InitialStress::none, input::InitialStress::k0}) {
    data.initial.stress = stress;
    expect_stress(
        data, [](double y) { return -0.7 * dry_weight * (depth - y); }, "r_u");
  }
}

TEST(GroundLoads, AWaterTableWithoutPoreWaterMakesSoilBuoyant) {
  input::Case data = make_frozen_case();
  input::Material& soil = data.materials["soil"];
  soil.slices.unit_weight = 18e3;
  soil.slices.saturated_unit_weight = 20e3;
  const double level = 1.5;
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, level}};
  expect_stress(
      data,
      [&](double y) {
        const double above = std::min(depth - y, depth - level), below = std::max(0.0, level - y);
        return -18e3 * above - (20e3 - water_weight) * below;
      },
      "water table");
}

TEST(GroundLoads, StandingWaterPressesOnTheGroundAndChangesNoEffectiveStress) {
  input::Case data = make_frozen_case();
  data.materials["soil"].slices.saturated_unit_weight = 20e3;
  data.materials["soil"].slices.unit_weight = 18e3;
  data.mesh.dimension = 2;
  data.mesh.polygons = {{"soil", {{0, 0}, {0.5, 0}, {0.5, depth}, {0, depth}}}};
  for (const double level : {depth, depth + 2, depth + 5}) {
    data.initial.water.pressure = input::InitialPressure::water_table;
    data.initial.water.water_table = {{0, level}};
    for (const input::InitialStress stress : {input::InitialStress::none, input::InitialStress::k0}) {
      data.initial.stress = stress;
      expect_stress(
          data, [](double y) { return -(20e3 - water_weight) * (depth - y); }, "water at " + std::to_string(level));
    }
  }
}

/// Returns the fall of a cliff of 1 m that yields, after half a second.
double find_fall(const input::Material& soil) {
  input::Case data = make_box_case<2>(soil);
  auto body = run::prepare<2>(data, make_step_mesh<2>());
  run::set_strength(body, data, {}, 1.2);
  run_plan(body, make_stage(data, body, 0.5, hold()));
  return mpm::find_largest_displacement(body).value;
}

TEST(GroundLoads, CohesionGrowsWithDepthAtThePoints) {
  input::Material coulomb = make_elastic(), tresca = coulomb;
  coulomb.model = material::model_of<material::MohrCoulomb>;
  coulomb.cohesion = tresca.undrained_strength = 3e3;
  coulomb.cohesion_gradient = tresca.undrained_gradient = 2e3;
  coulomb.cohesion_level = tresca.undrained_level = 2;
  coulomb.tensile_strength = 1e12;
  tresca.model = material::model_of<material::Tresca>;
  const double fall = find_fall(coulomb);
  EXPECT_NEAR(fall, find_fall(tresca), 1e-9 * fall) << "φ = 0: the same soil";
  input::Material even = coulomb;
  even.cohesion_gradient = 0;
  EXPECT_GT(find_fall(even), 1.05 * fall) << "the soil yields where it is weaker";
}

}  // namespace
}  // namespace talus
