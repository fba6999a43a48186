// SPDX-License-Identifier: MIT
// Rain above the infiltration capacity: it ponds on the ground, runs off to places of infiltration, and closes its
// budget.

#include <gtest/gtest.h>

#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

constexpr double hour = 3600;  // [s]

/// A box whose ground falls to the left, from 1.4 m at x = 2 m to 1 m at x = 0; "other" soil from the middle on.
mesh::Mesh<2> make_slope(double fall = 0.2) {
  auto mesh = make_soil_box<2>(
      {20, 8}, {2, 1}, [](const Vec<2>& x) { return x[0] > 1 ? 1 : 0; }, 0);
  for (auto& x : mesh.nodes) x[1] *= 1 + fall * x[0];
  mesh::finish(mesh);
  return mesh;
}

HydraulicSoil<2> make_silt(double conductivity) {
  auto soil = make_soil<2>(conductivity, 0.4);
  soil.retention = material::VanGenuchten{0.1, 1, 5e3, 0.4};
  soil.skeleton_compressibility = 1e-6;
  soil.relative = material::ExponentialConductivity{1 / gamma_w};
  return soil;
}

fem::SeepageHistory<2> rain(const mesh::Mesh<2>& mesh, const std::vector<HydraulicSoil<2>>& soils, double rate,
                            double standing_depth, bool runs_on, double end, double stop) {
  SeepageModel<2> model{&mesh, soils, {}};
  model.boundaries = {make_condition(mesh, "top", HydraulicKind::rain, rate),
                      make_condition(mesh, "bottom", HydraulicKind::pressure, gamma_w)};
  auto& top = model.boundaries[0];
  top.measure = fem::FluxMeasure::vertical;
  top.history = {{0, rate}, {stop, rate}, {stop, 0}, {end, 0}};
  top.standing_depth = standing_depth;
  top.runs_on = runs_on;
  std::vector<double> head(mesh.nodes.size(), -1.0);  // suctions of 1 to 2.4 m
  fem::SeepageSchedule schedule;
  for (int i = 1; i <= 8; ++i) schedule.outputs.push_back(end * i / 8);
  schedule.first_step = 1;
  schedule.head_tolerance = 2e-3;
  return fem::solve_transient_seepage(model, head, schedule);
}

double find_gain(const std::vector<fem::Discharge>& volumes) {
  double gain = 0;
  for (const fem::Discharge& d : volumes) gain += d.inflow - d.outflow;
  return gain;
}

TEST(SeepageRunoff, RunsFromTightGroundToWhereItEnters) {
  const auto mesh = make_slope();
  const double rate = 2e-5, end = 2 * hour, offered = rate * end * 2;
  const std::vector<HydraulicSoil<2>> soils{make_silt(1e-4), make_silt(1e-9)};
  const auto gone = rain(mesh, soils, rate, 0, false, end, end), on = rain(mesh, soils, rate, 0, true, end, end);
  const auto &lost = gone.volumes.back()[0], &kept = on.volumes.back()[0];
  EXPECT_NEAR(lost.inflow + lost.runoff, offered, 1e-6 * offered);
  EXPECT_GT(lost.runoff, 0.35 * offered) << "the upper half lets hardly any in";
  // Below it all of it enters.
  EXPECT_NEAR(kept.runoff, 0, 1e-5 * offered);
  EXPECT_NEAR(kept.inflow, offered, 1e-5 * offered);
  EXPECT_NEAR(on.stored.back(), find_gain(on.volumes.back()), 1e-8 * offered);
}

TEST(SeepageRunoff, RunoffWithoutALowerNodeLeavesTheSection) {
  const auto mesh = make_slope();
  const double rate = 5e-5, end = 2 * hour, offered = rate * end * 2;
  const std::vector<HydraulicSoil<2>> soils{make_silt(1e-8), make_silt(1e-8)};
  const auto on = rain(mesh, soils, rate, 0, true, end, end), gone = rain(mesh, soils, rate, 0, false, end, end);
  const auto& volume = on.volumes.back()[0];
  EXPECT_GT(volume.runoff, 0.8 * offered);
  EXPECT_NEAR(volume.inflow + volume.runoff, offered, 1e-5 * offered);
  EXPECT_NEAR(volume.inflow, gone.volumes.back()[0].inflow, 1e-3 * offered) << "all ground is wet already";
}

// Soil of low conductivity, wet from the start of the rain: water ponds up to the given depth, and infiltrates after
// the rain.
TEST(SeepageRunoff, PondsUpToItsDepthAndInfiltratesLater) {
  const auto mesh = make_slope(0);
  const double rate = 1e-5, depth = 5e-3, stop = 1 * hour, end = 8 * hour;
  const std::vector<HydraulicSoil<2>> soils{make_silt(2e-7), make_silt(2e-7)};
  const auto gone = rain(mesh, soils, rate, 0, false, end, stop);
  const auto stands = rain(mesh, soils, rate, depth, false, end, stop);
  const double offered = rate * stop * 2;
  for (std::size_t i = 0; i < stands.volumes.size(); ++i) {
    const auto& v = stands.volumes[i][0];
    EXPECT_LE(v.standing, 2 * depth * (1 + 1e-9));
    EXPECT_NEAR(v.inflow + v.runoff + v.standing, offered, 1e-5 * offered) << i;
    EXPECT_NEAR(stands.stored[i], find_gain(stands.volumes[i]), 1e-8 * offered);
  }
  EXPECT_NEAR(stands.volumes.front()[0].standing, 2 * depth, 1e-9) << "when the rain ends";
  const auto &late = stands.volumes.back()[0], &without = gone.volumes.back()[0];
  EXPECT_NEAR(late.inflow + late.standing - without.inflow, 2 * depth, 0.02 * depth) << "what stood has entered";
}

}  // namespace
}  // namespace talus
