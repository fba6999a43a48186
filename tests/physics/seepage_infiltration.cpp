// SPDX-License-Identifier: MIT
// Transient seepage against closed forms: Srivastava and Yeh's infiltration, consolidation, drainage; and water
// budgets.

#include <gtest/gtest.h>

#include <numbers>

#include "physics/seepage_box.hpp"
#include "physics/srivastava_yeh.hpp"

namespace talus {
namespace {

using namespace support;

constexpr double hour = 3600, cm = 0.01;

TEST(SeepageInfiltration, SrivastavaAndYehInTime) {
  const SrivastavaYeh exact;
  // Values computed independently by finite differences and by the series, z = 60 cm and 90 cm
  EXPECT_NEAR(exact.find_suction(60 * cm, 5 * hour) / cm, 19.54, 0.006);
  EXPECT_NEAR(exact.find_suction(90 * cm, 1 * hour) / cm, 17.43, 0.006);
  EXPECT_NEAR(exact.find_suction(30 * cm, 20 * hour) / cm, 8.49, 0.006);

  const int n = 100;
  const auto mesh = make_soil_box<2>({2, n}, {2 * exact.length / n, exact.length});
  auto soil = make_soil<2>(exact.ks, exact.theta_s);
  soil.retention = material::ExponentialRetention{exact.theta_r / exact.theta_s, 1, exact.alpha / gamma_w};
  soil.relative = material::ExponentialConductivity{exact.alpha / gamma_w};
  SeepageModel<2> model{&mesh, {soil}, {}};
  model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::pressure, 0.0),
                      make_condition(mesh, "top", HydraulicKind::flux, exact.q_a * exact.ks)};
  const auto before = fem::solve_steady_seepage(model);
  model.boundaries[1].value = exact.q_b * exact.ks;
  fem::SeepageSchedule schedule;
  for (double t : {1, 2, 3, 5, 10, 20}) schedule.outputs.push_back(t * hour);
  schedule.first_step = 1;
  schedule.head_tolerance = 1e-4;
  const auto history = fem::solve_transient_seepage(model, before.head, schedule);
  ASSERT_EQ(history.states.size(), 6u);
  for (std::size_t s = 0; s < 6; ++s) {
    const auto& state = history.states[s];
    double worst = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      worst = std::max(
          worst, std::abs(state.pressure[i] / gamma_w - exact.find_suction(mesh.nodes[i][1], schedule.outputs[s])));
    const auto& v = history.volumes[s];
    const double in = v[0].inflow + v[1].inflow, out = v[0].outflow + v[1].outflow;
    EXPECT_LT(worst, 0.2 * cm) << schedule.outputs[s] / hour << " h";
    EXPECT_NEAR(in - out, history.stored[s], 1e-10 * in);
    EXPECT_NEAR(v[1].inflow, exact.q_b * exact.ks * schedule.outputs[s] * 2 * exact.length / n, 1e-12 * in);
  }
}

/// Rain on silt, high above the origin: pressures are differences of heads, which must not drown in the elevation.
TEST(SeepageInfiltration, DoesNotDependOnTheDatum) {
  constexpr int n = 24;
  const auto calculate = [&](double datum) {
    auto mesh = make_soil_box<2>({2, n}, {0.5, 6.0});
    auto soil = make_soil<2>(1e-6, 0.42);
    soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.4};
    soil.relative = material::Mualem{0.4};
    SeepageModel<2> model{&mesh, {soil}, {}};
    model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::pressure, -20e3),
                        make_condition(mesh, "top", HydraulicKind::rain, 2e-8)};
    for (auto& x : mesh.nodes) x[1] += datum;
    const auto before = fem::solve_steady_seepage(model);
    model.boundaries[1].value = 4e-7;
    fem::SeepageSchedule schedule;
    schedule.outputs = {6 * hour, 24 * hour, 72 * hour};
    return fem::solve_transient_seepage(model, before.head, schedule).states.back().pressure;
  };
  const std::vector<double> here = calculate(0), above = calculate(850);
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(above[i], here[i], 1e-3 * gamma_w * cm);
}

TEST(SeepageInfiltration, SaturatedStorageIsTerzaghisConsolidation) {
  // c_v = k/(γ_w (n/K_w + 1/E_c)); excess pressure p0 at the start, drained at the top
  const int n = 40;
  const double height = 1, k = 1e-6, p0 = -10e3;
  const auto mesh = make_soil_box<2>({2, n}, {0.05, height});
  auto soil = make_soil<2>(k, 0.3);
  soil.water_modulus = 2e9;
  soil.skeleton_compressibility = 1e-7;
  const double cv = k / (gamma_w * (0.3 / 2e9 + 1e-7));
  SeepageModel<2> model{&mesh, {soil}, {make_condition(mesh, "top", HydraulicKind::pressure, 0.0)}};
  std::vector<double> head;
  for (const auto& x : mesh.nodes) head.push_back(height - p0 / gamma_w * (x[1] < height - 1e-9));
  fem::SeepageSchedule schedule;
  for (double tv : {0.05, 0.2, 0.5, 1.0}) schedule.outputs.push_back(tv * height * height / cv);
  schedule.first_step = schedule.outputs[0] * 1e-4;
  schedule.head_tolerance = 2e-4;
  const auto history = fem::solve_transient_seepage(model, head, schedule);
  for (std::size_t s = 0; s < 4; ++s) {
    double worst = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      const double z = height - mesh.nodes[i][1], hydrostatic = -gamma_w * z;
      double ratio = 0;
      for (int m = 0; m < 60; ++m) {
        const double a = std::numbers::pi / 2 * (2 * m + 1);
        ratio += 2 / a * std::sin(a * z) * std::exp(-a * a * cv * schedule.outputs[s]);
      }
      worst = std::max(worst, std::abs((history.states[s].pressure[i] - hydrostatic) / p0 - ratio));
    }
    EXPECT_LT(worst, 5e-3);
  }
}

TEST(SeepageInfiltration, DrainedColumnRetainsTheWaterOfItsCurve) {
  // From full to rest over a water table: what has left is ∫ n (1 - S(γ_w z)) dz.
  const double height = 2, n = 0.35;
  const auto mesh = make_soil_box<2>({2, 80}, {0.05, height});
  auto soil = make_soil<2>(1e-4, n);
  soil.retention = material::VanGenuchten{0.1, 1, 5e3, 0.6};
  soil.relative = material::Mualem{0.6, material::SaturationMeasure::effective};
  SeepageModel<2> model{&mesh, {soil}, {make_condition(mesh, "bottom", HydraulicKind::pressure, 0.0)}};
  const std::vector<double> full(mesh.nodes.size(), height);
  fem::SeepageSchedule schedule;
  schedule.outputs = {600, 3600, 86400, 5e8};
  schedule.first_step = 0.01;
  schedule.head_tolerance = 0.01;
  fem::SeepageOptions options;
  options.smallest_conductivity = 1e-14;
  const auto history = fem::solve_transient_seepage(model, full, schedule, options);
  double last = 0;
  for (std::size_t s = 0; s < 4; ++s) {
    const double out = history.volumes[s][0].outflow - history.volumes[s][0].inflow;
    EXPECT_NEAR(out, -history.stored[s], 1e-10 * out);
    EXPECT_GT(out, last);
    last = out;
  }
  double held = 0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i)
    held += material::saturation<double>(soil.retention, gamma_w * height * (i + 0.5) / steps) * height / steps;
  EXPECT_NEAR(last / (0.05 * n * (height - held)), 1, 2e-3);
  for (double h : history.states.back().head) EXPECT_NEAR(h, 0, 0.02);
}

TEST(SeepageInfiltration, DrySoilBesideTheWaterNeedsNoStore) {
  auto mesh = make_soil_box<2>(
      {8, 4}, {2, 1}, [](const Vec<2>& x) { return x[0] > 1 ? 1 : 0; }, 0.0);
  auto wet = make_soil<2>(1e-6), dry = make_soil<2>(1);
  wet.water_modulus = 2e9;
  SeepageModel<2> model{&mesh, {wet, dry}, {make_condition(mesh, "left", HydraulicKind::total_head, 1.5)}};
  const std::vector<double> head(mesh.nodes.size(), 2);
  fem::SeepageSchedule schedule;
  schedule.outputs = {1e5};
  EXPECT_THROW(fem::solve_transient_seepage(model, head, schedule), Error);  // while the dry soil is part of the mesh
  for (int& region : mesh.element_region)
    if (region == 1) region = mesh::empty_region;
  const auto history = fem::solve_transient_seepage(model, head, schedule);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (mesh.nodes[i][0] > 1) continue;
    EXPECT_NEAR(history.states[0].head[i], 1.5, 1e-6);
  }
}

TEST(SeepageInfiltration, RainBeyondTheSoilsIntakeRunsOffAndIsCounted) {
  const auto mesh = make_soil_box<2>({4, 60}, {0.2, 1});
  auto soil = make_soil<2>(1e-6, 0.4);
  soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.5};
  soil.relative = material::Mualem{0.5, material::SaturationMeasure::effective};
  SeepageModel<2> model{&mesh, {soil}, {}};
  model.boundaries = {make_condition(mesh, "top", HydraulicKind::rain),
                      make_condition(mesh, "bottom", HydraulicKind::free_drainage)};
  model.boundaries[0].history = {{0, 5e-5}, {3600, 5e-5}, {3600, 0}, {7200, 0}};
  std::vector<double> head;
  for (const auto& x : mesh.nodes) head.push_back(x[1] - 3);  // 3 m of suction everywhere
  fem::SeepageSchedule schedule;
  schedule.outputs = {10, 3600, 7200};
  schedule.first_step = 0.1;
  schedule.head_tolerance = 0.02;
  const auto history = fem::solve_transient_seepage(model, head, schedule);
  for (std::size_t s = 0; s < 3; ++s) {
    const auto& top = history.volumes[s][0];
    const double fallen = 0.2 * 5e-5 * std::min(schedule.outputs[s], 3600.0);
    EXPECT_NEAR(top.inflow + top.runoff, fallen, 1e-10 * fallen);
    EXPECT_NEAR(top.inflow - top.outflow - history.volumes[s][1].outflow, history.stored[s], 1e-9 * fallen);
  }
  EXPECT_EQ(history.volumes[0][0].runoff, 0);  // at first all of it enters
  EXPECT_GT(history.volumes[1][0].runoff, 0.1 * 0.2 * 5e-5 * 3600);
  EXPECT_EQ(history.volumes[2][0].inflow, history.volumes[1][0].inflow);  // the rain has stopped
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_GE(history.states[1].pressure[i], -1e-6);  // ponded at most
}

TEST(SeepageInfiltration, EvaporationStopsAtTheSuctionLimit) {
  const auto mesh = make_soil_box<2>({2, 30}, {0.1, 0.5});
  auto soil = make_soil<2>(1e-6, 0.4);
  soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.5};
  soil.relative = material::Mualem{0.5, material::SaturationMeasure::effective};
  soil.water_modulus = 2e9;
  SeepageModel<2> model{&mesh, {soil}, {make_condition(mesh, "top", HydraulicKind::rain, -2e-7)}};
  model.boundaries[0].suction_limit = 200e3;
  const std::vector<double> head(mesh.nodes.size(), 0.5);
  fem::SeepageSchedule schedule;
  schedule.outputs = {3600, 30 * 86400.0};
  schedule.first_step = 1;
  schedule.head_tolerance = 0.05;
  const auto history = fem::solve_transient_seepage(model, head, schedule);
  EXPECT_NEAR(history.volumes[0][0].outflow, 0.1 * 2e-7 * 3600, 1e-12);  // equal to the potential at first
  EXPECT_LT(history.volumes[1][0].outflow, 0.5 * 0.1 * 2e-7 * 30 * 86400);
  for (std::size_t s = 0; s < 2; ++s) EXPECT_NEAR(history.volumes[s][0].outflow, -history.stored[s], 1e-12);
  double most = 0;
  for (double p : history.states[1].pressure) most = std::max(most, p);
  EXPECT_NEAR(most, 200e3, 1e-3);
}

}  // namespace
}  // namespace talus
