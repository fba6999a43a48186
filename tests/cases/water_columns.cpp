// SPDX-License-Identifier: MIT
// Columns of examples/verification by `talus run`: undrained wave, consolidation, hydrostatic water and Darcy flow. The
// full runs are in tools/verify_water.py.

#include <cmath>
#include <numbers>

#include "cases/water_run.hpp"

namespace talus {
namespace {

constexpr double water_weight = 9810;  // of water [N/m³]

TEST(WaterColumns, UndrainedWaveHasThePublishedStepHeightAndTimes) {
  const WaterRun run("wave/case.toml", {{"output.history_interval", "2e-6"}});
  EXPECT_NEAR(run.summary.at("stages")[0].at("time_step").get<double>() / 0.98, 3.674e-7, 1e-10);
  const auto time = run.column("time", "monitors.csv"), p = run.column("middle.pore_pressure", "monitors.csv"),
             mean = run.column("middle.mean_stress", "monitors.csv");
  double plateau = 0, effective = 0, arrival = 0, doubling = 0;
  int count = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const auto when = [&](double level) {
      return time[i] - (time[i] - time[i - 1]) * (p[i] - level) / (p[i] - p[i - 1]);
    };
    if (arrival == 0 && p[i] >= 0.49875) arrival = when(0.49875);
    if (doubling == 0 && p[i] >= 1.49625) doubling = when(1.49625);
    if (time[i] < 4e-4 || time[i] > 8e-4) continue;
    plateau += p[i], effective -= mean[i] * 3 * 0.7 / 1.3, ++count;  // uniaxial: σ_y' = 3(1-ν)/(1+ν) of the mean
  }
  EXPECT_NEAR(plateau / count, 0.99750, 0.001);
  EXPECT_NEAR(effective / count, 0.00250, 0.00002);
  EXPECT_NEAR(arrival, 3.039e-4, 0.015e-4);
  EXPECT_NEAR(doubling, 9.116e-4, 0.015e-4);
  // The only force until the wave meets the bottom is the load: 1 kPa on 1 mm.
  const auto momentum = run.column("momentum_y"), moment = run.column("time");
  for (std::size_t i = 0; i < moment.size() && moment[i] < 5.5e-4; ++i)
    EXPECT_NEAR(momentum[i], -moment[i], 1e-9) << moment[i];
  EXPECT_LT(run.budget_error, 1e-11);
}

/// Net damping increases explicit drag by its fraction; a time step without this factor was unstable within forty
/// steps.
TEST(WaterColumns, ExplicitDragUnderHeavyDampingNeedsNoSmallerStep) {
  for (const char* permeability : {"1.0214e-12", "1.0214e-15"}) {
    const WaterRun run("terzaghi/case.toml", {{"stage.consolidation.drag", "explicit"},
                                              {"stage.consolidation.damping", "0.75"},
                                              {"stage.consolidation.water_damping", "0.75"},
                                              {"stage.consolidation.mass_scaling", "40"},
                                              {"stage.consolidation.duration", "1e-4"},
                                              {"materials.soil.water.permeability", permeability}});
    EXPECT_FALSE(run.summary.at("stages")[0].contains("setbacks")) << permeability;
  }
}

TEST(WaterColumns, ConsolidationFollowsTerzaghiAtHundredsOfTimesThePrintedStep) {
  const double modulus = 1e7 * 0.7 / 0.52, storage = 1 / modulus + 0.4 / 2.15e9;
  const double c_v = 1000 * 9.81 / 1.002e-3 * 1.0214e-13 / (water_weight * storage), start = 1e4 / modulus / storage;
  const WaterRun run("terzaghi/case.toml", {{"stage.consolidation.mass_scaling", "1e6"},
                                            {"stage.consolidation.duration", "293"},
                                            {"output.frame_interval", "146.11"}});
  EXPECT_GT(run.summary.at("stages")[0].at("time_step").get<double>(), 400 * 1.48e-5);
  const struct { double factor, bound; } isochrones[] = {{0.2, 0.03}, {0.4, 0.01}};
  for (const auto& [factor, bound] : isochrones) {
    const output::Frame frame = run.frame(factor / c_v);
    double largest = 0, degree = 1, settlement = 0;
    for_each_element(frame, "pore_pressure", [&, t = frame.time * c_v](double y, double p) {
      double exact = 0;
      for (int k = 1; k < 100; ++k) {
        const double m = (2 * k - 1) * std::numbers::pi / 2;
        exact += 2 / m * std::sin(m * (1 - y)) * std::exp(-m * m * t);
      }
      largest = std::max(largest, std::abs(p / start - exact));
    });
    EXPECT_LT(largest, bound) << "T = " << factor;
    for (int k = 1; k < 100; ++k) {
      const double m = (2 * k - 1) * std::numbers::pi / 2;
      degree -= start / 1e4 * 2 / (m * m) * std::exp(-m * m * frame.time * c_v);
    }
    const auto strain = take(frame, "strain", 6, 1), volume = take(frame, "volume");
    for (std::size_t i = 0; i < strain.size(); ++i) settlement -= strain[i] * volume[i] / 0.1;
    EXPECT_NEAR(settlement / (1e4 / modulus), degree, 0.005) << "T = " << factor;
  }
  EXPECT_LT(run.budget_error, 1e-10);
}

TEST(WaterColumns, WaterAtRestStaysAtRest) {
  for (const char* file : {"hydrostatic/saturated.toml", "hydrostatic/suction.toml"})
    for (const char* water : {"\"seeps\"", "\"flows\""}) {
      SCOPED_TRACE(fmt::format("{}, water = {}", file, water));
      const WaterRun run(file, {{"stage.rest.duration", "1"}, {"stage.rest.water", water}});
      const auto before = take(run.frame(0), "pore_pressure"), after = take(run.frame(1), "pore_pressure");
      ASSERT_FALSE(before.empty());
      for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1);  // of 10 to 30 kPa
      EXPECT_LT(run.last("largest_displacement"), 1e-4);                                    // mm
      for (const double speed : run.column("nodal_speed")) EXPECT_LT(speed, 2e-6);
      EXPECT_LT(run.budget_error, 1e-11);
    }
}

// Real water in soil whose points change their elements: if the pores of a full element grow by more or less than
// the volume its forces act over, an oscillation grows at any time step.
void expect_rest_after_settling(const std::vector<input::Override>& changes) {
  std::vector<input::Override> overrides = {{"stage.settling.duration", "40"}};
  overrides.insert(overrides.end(), changes.begin(), changes.end());
  const WaterRun run("hydrostatic/settling.toml", overrides);
  const output::Frame frame = run.frame(40);
  const auto pressure = take(frame, "pore_pressure");
  ASSERT_FALSE(pressure.empty());
  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(pressure[i], water_weight * (3 - frame.positions[3 * i + 1]), 1500);  // still draining: 700 Pa
  EXPECT_LT(run.column("nodal_speed").back(), 1e-3);
  EXPECT_LT(run.budget_error, 1e-10);
}

TEST(WaterColumns, SoftColumnSettlesAndItsWaterComesToRest) {
  expect_rest_after_settling({});
}

// Two velocities fail this: "What does not hold" in docs/verification.md.
TEST(WaterColumns, SoftColumnInTheDarcyFormulationSettlesWithSmoothing) {
  for (const char* smoothing : {"\"stable\"", "\"strain\""})
    for (const char* size : {"0.05", "0.07"}) {
      SCOPED_TRACE(fmt::format("{}, {} m", smoothing, size));
      expect_rest_after_settling(
          {{"stage.settling.water", "\"seeps\""}, {"stage.settling.smoothing", smoothing}, {"mesh.size", size}});
    }
}

TEST(WaterColumns, DischargeThroughLayersIsDarcys) {
  const double exact = 0.3 * 0.4 / (1 / 1e-4 + 1 / 4e-5);
  for (const char* geometry : {"\"frozen\"", "\"moving\""}) {
    const WaterRun run("darcy/case.toml", {{"stage.flow.geometry", geometry}, {"stage.flow.mass_scaling", "1e4"}});
    const bool frozen = geometry[1] == 'f';
    const double bound = frozen ? 1e-5 : 1e-3;  // moving: the surface of the soil rises, the standing water does not
    EXPECT_NEAR(run.last("bottom.inflow") / exact, 1, bound) << geometry;
    EXPECT_NEAR(run.last("top.outflow") / exact, 1, bound) << geometry;
    if (!frozen) {
      EXPECT_LT(run.budget_error, 1e-11);
    }
  }
}

}  // namespace
}  // namespace talus
