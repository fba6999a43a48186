// SPDX-License-Identifier: MIT
// Infiltration, drainage, flow around a corner and a dam of examples/verification by `talus run`, with a larger step
// and a shorter time than the full runs in tools/verify_water.py.

#include <cmath>
#include <numbers>

#include "cases/water_run.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810;  // of water [N/m³]

/// Srivastava and Yeh (1991): suction [m] at height z [m] after t [s] of rain of 0.9 k_s, with 0.1 k_s before.
double find_suction(double z, double t) {
  const double l = 10, zs = 10 * z, ts = 10 * (0.01 / 3600) * t / 0.34;
  double sum = 0;
  for (int i = 1; i < 400; ++i) {
    double a = (i - 0.5) * std::numbers::pi / l + 1e-12, b = i * std::numbers::pi / l;
    for (int k = 0; k < 80; ++k) {
      const double m = 0.5 * (a + b);
      (std::tan(m * l) + 2 * m < 0 ? a : b) = m;
    }
    sum += std::sin(a * zs) * std::sin(a * l) * std::exp(-a * a * ts) / (1 + l / 2 + 2 * a * a * l);
  }
  return -std::log(0.9 + 0.1 * std::exp(-zs) - 3.2 * std::exp((l - zs) / 2) * std::exp(-ts / 4) * sum) / 10;
}

TEST(WaterFlow, InfiltrationFollowsSrivastavaAndYeh) {
  const WaterRun run("infiltration/case.toml",
                     {{"stage.rain.duration", "\"2 h\""}, {"stage.rain.mass_scaling", "1e7"}});
  for (const double hours : {1.0, 2.0}) {
    const output::Frame frame = run.frame(hours * 3600);
    double largest = 0;
    for_each_element(frame, "pore_pressure", [&](double z, double p) {
      largest = std::max(largest, std::abs(-p / gamma_w - find_suction(z, frame.time - 1)));
    });
    EXPECT_LT(largest, 0.003) << hours << " h: of 0.23 m";
  }
  EXPECT_NEAR(run.last("top.inflow") / 0.02 / (0.009 / 3600), 1, 1e-4);
  EXPECT_LT(run.budget_error, 1e-9);
}

TEST(WaterFlow, DrainedColumnGivesTheWaterOfRichardsEquation) {
  const WaterRun run("drainage/case.toml",
                     {{"stage.drainage.duration", "\"1 h\""}, {"stage.drainage.mass_scaling", "1e7"}});
  // 400 cells, backward Euler: tools/water_checks/drainage.py
  EXPECT_NEAR(run.summary.at("water").at("left").get<double>() / 1000 / 0.02, 0.027630, 0.0003);
  EXPECT_LT(run.budget_error, 1e-9);
}

TEST(WaterFlow, RainBelowTheSaturatedConductivityEntersDrySoilThroughCoarseElements) {
  // k_sat is 36 mm/h, but 0.04 of it at the suction of the start, 25 kPa. The wetted depth is a few per cent of an
  // element.
  const WaterRun run("../storm_on_a_bank/case.toml",
                     {{"mesh.size", "0.6"}, {"hydraulic.0.rate", "\"18 mm/h\""}, {"stage.1.duration", "60"}});
  const auto& ground = run.summary.at("water").at("surfaces").at(1);
  EXPECT_NEAR(ground.at("supplied").get<double>(), 1000 * 14 * 5e-6 * 60, 0.01);
  EXPECT_LT(ground.at("runoff").get<double>(), 0.01 * ground.at("supplied").get<double>());
  EXPECT_LT(std::abs(run.budget_error), 1e-9);
}

TEST(WaterFlow, FlowRoundACornerApproachesItsExactDischarge) {
  // Conformal mapping: 0.68062 k Δh (tools/water_checks/corner.py). The inlet's ends are singular: first order at best.
  const double exact = 0.68062 * 1e-4 * 0.5;
  const struct {
    const char* smoothing;
    double largest, ratio;
  } variants[] = {{"false", 0.17, 0.65}, {"true", 0.13, 0.55}};
  for (const auto& [smoothing, largest, ratio] : variants) {
    double before = 0;
    for (const char* size : {"0.1", "0.05"}) {
      const WaterRun run(
          "corner/case.toml",
          {{"mesh.size", size}, {"stage.flow.duration", "20"}, {"stage.flow.pressure_smoothing", smoothing}});
      const std::vector<double> outflow = run.column("outlet.outflow"), inflow = run.column("inlet.inflow");
      const double error = 1 - outflow.back() / exact;
      EXPECT_NEAR(inflow.back(), outflow.back(), 1e-3 * exact) << smoothing << ' ' << size;
      // Flow that locks falls by 3 % in these 10 s.
      EXPECT_NEAR(outflow[outflow.size() / 2] / exact, 1 - error, 1e-3) << "steady: " << smoothing << ' ' << size;
      EXPECT_LT(std::abs(error), largest) << smoothing << ' ' << size;
      if (before != 0) {
        EXPECT_LT(std::abs(error), ratio * before) << smoothing << ' ' << size;
      }
      before = std::abs(error);
    }
  }
}

/// Pressures at the nodes: the discharge is that of the seepage solver on the same mesh, whatever the size of the
/// elements, the stiffness of the water and the step.
TEST(WaterFlow, DarcyFormulationHasTheDischargeOfTheSeepageSolver) {
  const struct {
    const char *size, *modulus, *scaling;
  } variants[] = {{"0.1", "\"20 MPa\"", "1000"}, {"0.05", "\"2.2 GPa\"", "1000"}, {"0.1", "\"2.2 GPa\"", "100"}};
  for (const char* file : {"corner/case.toml", "sheet_pile/case.toml"})
    for (const auto& [size, modulus, scaling] : variants) {
      const WaterRun run(file, {{"mesh.size", size},
                                {"water.bulk_modulus", modulus},
                                {"stage.flow.mass_scaling", scaling},
                                {"stage.flow.damping", "0.5"},
                                {"stage.flow.duration", "20"},
                                {"stage.flow.water", "\"seeps\""}});
      const double solver = run.summary.at("seepage").at("inflow").get<double>();
      SCOPED_TRACE(std::string(file) + ' ' + size + ' ' + modulus + ' ' + scaling);
      EXPECT_NEAR(run.last("outlet.outflow") / solver, 1, 0.002);
      EXPECT_NEAR(run.last("inlet.inflow") / solver, 1, 0.002);
      EXPECT_LT(std::abs(run.budget_error), 1e-11);
    }
}

/// p/p0 of de Leeuw's cylinder for η = G/E_c = 0.375 and rigid water (tools/water_checks/poroelastic.py), at r/R and T.
double find_de_leeuw(double r, double factor) {
  constexpr double shear = 0.375;
  const auto left = [](double z) { return std::cyl_bessel_j(0, z) - 2 * shear * std::cyl_bessel_j(1, z) / z; };
  double sum = 0;
  for (int k = 0; k < 20; ++k) {
    double low = (k + 1e-9) * std::numbers::pi, high = (k + 1 - 1e-9) * std::numbers::pi;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      ((left(middle) > 0) == (left(low) > 0) ? low : high) = middle;
    }
    sum += 2 * (std::cyl_bessel_j(0, low * r) - std::cyl_bessel_j(0, low)) * std::exp(-low * low * factor) /
           (low * std::cyl_bessel_j(1, low) - 2 * shear * std::cyl_bessel_j(2, low));
  }
  return sum;
}

/// Real water, no mass scaling; the load rises within 0.05 s, and the round has four chords of 7.5 degrees.
TEST(WaterFlow, CylinderThatDrainsHasDeLeeuwsPressures) {
  const double end = 8.82, chord = std::numbers::pi / 24, square = std::sin(chord) / chord;
  const WaterRun run("de_leeuw/case.toml", {{"stage.consolidation.duration", std::to_string(end)}});
  const double modulus = 1e7 * 0.8 / (1.2 * 0.6), speed = 1e-5 * modulus / 9810 / (1 + 0.4 * modulus / 2.2e9);
  const output::Frame frame = run.frame(end);
  const std::vector<double> pressure = take(frame, "pore_pressure");
  std::vector<std::array<double, 3>> means(pressure.size() / 3);  // x, y, p of the elements
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    auto& mean = means.at(static_cast<std::size_t>(frame.ids[i]) / 3);
    mean[0] += frame.positions[3 * i] / 3, mean[1] += frame.positions[3 * i + 1] / 3, mean[2] += pressure[i] / 3e4;
  }
  double largest = 0;
  for (const auto& [x, y, p] : means) {
    const double exact = find_de_leeuw(std::hypot(x, y) / std::sqrt(square), speed * (end - 0.025) / square);
    EXPECT_NEAR(p, exact, 0.01) << x << ' ' << y;
    largest = std::max(largest, p);
  }
  EXPECT_GT(largest, 1.09) << "the pressure in the middle rises above the load";
  EXPECT_LT(std::abs(run.budget_error), 1e-11);
}

/// p/p0 of Mandel's strip for η = G/E_c = 0.375 and rigid water, at x/a and T.
double find_mandel(double x, double factor) {
  constexpr double shear = 0.375;
  double sum = 0;
  for (int k = 0; k < 20; ++k) {
    double low = k * std::numbers::pi + 1e-9, high = (k + 0.5) * std::numbers::pi - 1e-9;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (std::tan(middle) < middle / shear ? low : high) = middle;
    }
    sum += 2 * std::sin(low) / (low - std::sin(low) * std::cos(low)) * (std::cos(low * x) - std::cos(low)) *
           std::exp(-low * low * factor);
  }
  return sum;
}

/// Smooth plates with the velocity of the series: the pressures, and that the plate bears the load all the time.
TEST(WaterFlow, StripBetweenPlatesHasMandelsPressures) {
  const double end = 8.84;
  const WaterRun run("mandel/case.toml",
                     {{"stage.consolidation.duration", std::to_string(end)}, {"mesh.size", "0.05"}});
  const double modulus = 1e7 * 0.8 / (1.2 * 0.6), speed = 1e-5 * modulus / 9810 / (1 + 0.4 * modulus / 2.2e9);
  const output::Frame frame = run.frame(end);
  const std::vector<double> pressure = take(frame, "pore_pressure"), stress = take(frame, "stress", 6, 1),
                            volume = take(frame, "volume");
  double largest = 0, force = 0, area = 0;
  std::vector<std::array<double, 2>> means(pressure.size() / 3);  // x, p of the elements
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    auto& mean = means.at(static_cast<std::size_t>(frame.ids[i]) / 3);
    mean[0] += frame.positions[3 * i] / 3, mean[1] += pressure[i] / 3e4;
    force += (pressure[i] - stress[i]) * volume[i];
    area += volume[i];
  }
  for (const auto& [x, p] : means) {
    EXPECT_NEAR(p, find_mandel(x, speed * (end - 0.025)), 0.01) << x;
    largest = std::max(largest, p);
  }
  EXPECT_GT(largest, 1.08) << "the pressure in the middle rises above the load";
  EXPECT_NEAR(force / area / 2e4, 1, 0.005);
  EXPECT_LT(std::abs(run.budget_error), 1e-11);
}

TEST(WaterFlow, DamHasDupuitsDischarge) {
  const double dupuit = 1e-4 * (10 * 10 - 2 * 2) / 20;
  const std::vector<input::Override> steady = {{"mesh.size", "1"}, {"stage.flow.duration", "\"3 h\""}};
  std::vector<input::Override> low = steady;  // dry elements must fill
  low.push_back({"initial.pore_pressure", "\"water_table\""});
  low.push_back({"initial.water_table", "[[0, 10], [10, 4]]"});
  for (const auto& start : {steady, low}) {
    const WaterRun run("dam/case.toml", start);
    EXPECT_NEAR(run.last("left.inflow") / dupuit, 1, 0.03) << start.size();
    EXPECT_NEAR(run.last("right.outflow") / dupuit, 1, 0.03) << start.size();
    EXPECT_LT(run.budget_error, 1e-11);
    if (start.size() != steady.size()) continue;
    const double solver = run.summary.at("seepage").at("inflow").get<double>();
    EXPECT_NEAR(solver / dupuit, 1, 0.03);  // the fringe carries the rest
  }
}

}  // namespace
}  // namespace talus
