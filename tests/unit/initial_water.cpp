// SPDX-License-Identifier: MIT
// Initial pore pressure and stress, against the water table and the overburden above a point.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "support/points.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;
using input::WaterCondition;

constexpr double g = 9.81, water_weight = 1000 * g, soil_weight = (0.6 * 2650 + 0.4 * 1000) * g;

template <int D>
Vec<D> find_middle(const mesh::Mesh<D>& mesh, int e) {
  Vec<D> xi;
  xi.fill(1.0 / (D + 1));
  return mesh::to_global(mesh, e, xi);
}

/// 2 m × 3 m, full of wet soil.
mesh::Mesh<2> make_full_box() {
  return make_box_mesh<2>({4, 6}, {2, 3}, {"soil"}, [](const Vec<2>&) { return 0; });
}

TEST(InitialWater, WaterTableIsAPolylineAndSuctionIsCapped) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0.5, 1.0}, {1.5, 2.0}};
  data.initial.water.largest_suction = 12e3;
  const auto body = run::prepare<2>(data, make_full_box());
  for_each_point(body, [&](int, const mpm::PointView<2>& p) {
    const Vec<2> x = find_middle(body.mesh(), p.element);
    const double level = 1 + std::clamp(x[0] - 0.5, 0.0, 1.0);
    EXPECT_NEAR(p.pressure, std::min(12e3, water_weight * (x[1] - level)), 1e-6);
  });
}

TEST(InitialWater, MassOfTheWaterIsThatInThePores) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.materials["soil"].water.retention = input::RetentionCurve::linear;
  data.materials["soil"].water.dry_suction = 40e3;
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, -1.0}};
  data.initial.water.largest_suction = 20e3;
  const auto body = run::prepare<2>(data, make_full_box());
  for_each_point(body, [&](int, const mpm::PointView<2>& p) {
    const double saturation = 1 - p.pressure / 40e3;
    EXPECT_NEAR(p.saturation, saturation, 1e-12);
    EXPECT_NEAR(p.water_mass, 0.4 * saturation * 1000 * std::exp(-p.pressure / 2.2e9) * p.volume, 1e-9 * p.water_mass);
    EXPECT_NEAR(p.mass, 0.6 * 2650 * p.volume, 1e-9) << "of the grains";
  });
}

TEST(InitialWater, SteadySeepageOfStillWaterIsHydrostatic) {
  // By a level over the ground, and by the pressure that it makes below, positive in compression.
  const std::vector<std::vector<input::Hydraulic>> same{
      {make_hydraulic("top", WaterCondition::total_head, 4)},
      {make_hydraulic("top", WaterCondition::no_flow),
       make_hydraulic("bottom", WaterCondition::pressure, 4 * water_weight)}};
  for (const auto& hydraulics : same) {
    input::Case data = make_box_case<2>(make_wet_soil());
    data.hydraulics = hydraulics;
    data.initial.water.pressure = input::InitialPressure::seepage;
    std::optional<fem::SeepageResult<2>> seepage;
    const auto body = run::prepare<2>(data, make_full_box(), 0, &seepage);
    ASSERT_TRUE(seepage);
    for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      EXPECT_NEAR(p.pressure, water_weight * (find_middle(body.mesh(), p.element)[1] - 4), 1e-3);
      EXPECT_NEAR(norm(p.water_velocity), 0, 1e-12);
    });
  }
}

TEST(InitialWater, SteadySeepageHasDarcysVelocityAlsoUnderManyG) {
  for (const double times : {1.0, 10.0}) {
    input::Case data = make_box_case<2>(make_wet_soil());
    data.gravity.acceleration = times * g;
    data.hydraulics = {make_hydraulic("top", WaterCondition::total_head, 3),
                       make_hydraulic("bottom", WaterCondition::pressure, 0)};
    data.initial.water.pressure = input::InitialPressure::seepage;
    const auto body = run::prepare<2>(data, make_full_box());
    for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      EXPECT_NEAR(p.pressure, 0, 1e-3) << "a unit gradient of the head";
      EXPECT_NEAR(p.water_velocity[1], -times * 1e-4 / 0.4, 1e-9) << "k was measured under 1 g";
    });
  }
}

TEST(InitialWater, DrySoilTakesNoPart) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.materials["dry"] = make_elastic();
  data.materials["dry"].porosity = 0.3;
  data.regions["berm"] = "dry";
  data.hydraulics = {make_hydraulic("left", WaterCondition::total_head, 1.5)};
  data.initial.water.pressure = input::InitialPressure::seepage;
  const auto mesh = make_box_mesh<2>(
      {4, 6}, {2, 3}, {"soil", "berm"}, [](const Vec<2>& x) { return x[1] > 2; }, 0);
  const auto body = run::prepare<2>(data, mesh);
  int dry = 0;
  for_each_point(body, [&](int, const mpm::PointView<2>& p) {
    dry += !p.wet;
    if (!p.wet) {
      EXPECT_EQ(p.water_mass, 0);
      return;
    }
    EXPECT_NEAR(p.pressure, water_weight * (find_middle(body.mesh(), p.element)[1] - 1.5), 1e-3);
  });
  EXPECT_EQ(dry, 8 * 2 * 3) << "points of the upper metre";
}

/// Effective stress under level ground: the weight of soil and water above, less the pressure.
TEST(InitialStress, IsTheWeightAboveLessThePorePressure) {
  for (const double level : {2.0, 4.0}) {  // in the ground, and one metre of water over it
    input::Case data = make_box_case<2>(make_wet_soil());
    data.initial.stress = input::InitialStress::k0;
    data.initial.k0 = 0.5;
    data.initial.water.pressure = input::InitialPressure::water_table;
    data.initial.water.water_table = {{0, level}};
    data.hydraulics = {make_hydraulic("top", WaterCondition::total_head, level)};
    const auto body = run::prepare<2>(data, make_full_box());
    for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      const double total = -soil_weight * (3 - p.position[1]) - water_weight * std::max(0.0, level - 3);
      const double pressure = water_weight * (find_middle(body.mesh(), p.element)[1] - level);
      EXPECT_NEAR(p.stress[1], total - pressure, 1e-4 * std::abs(total) + 1) << "σ' = σ - p, positive in tension";
      EXPECT_NEAR(p.stress[0], 0.5 * p.stress[1], 1e-9 * std::abs(total));
      EXPECT_NEAR(p.stress[2], 0.5 * p.stress[1], 1e-9 * std::abs(total));
    });
  }
}

TEST(InitialStress, CarriesPondedWaterInThreeDimensions) {
  input::Case data = make_box_case<3>(make_wet_soil());
  data.initial.stress = input::InitialStress::k0;
  data.hydraulics = {make_hydraulic("foot", WaterCondition::total_head, 1.75)};
  const auto body = run::prepare<3>(data, make_step_mesh<3>());
  for_each_point(body, [&](int, const mpm::PointView<3>& p) {
    const bool under_water = p.position[0] > 2;
    const double total =
        -soil_weight * ((under_water ? 1 : 2) - p.position[1]) - (under_water ? 0.75 * water_weight : 0);
    EXPECT_NEAR(p.stress[1], total, 1e-4 * std::abs(total) + 1);
  });
}

TEST(InitialWater, LevelsNeedUprightGravity) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.gravity.direction = {std::sqrt(0.5), -std::sqrt(0.5), 0};
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, 1}};
  EXPECT_THROW((void)run::prepare<2>(data, make_full_box()), Error);
}

}  // namespace
}  // namespace talus
