// SPDX-License-Identifier: MIT
// Isotropic and one-dimensional compression, undrained shear and wetting against closed forms of critical state theory.

#include <gtest/gtest.h>

#include "support/clay_point.hpp"

namespace {

using namespace talus;
using support::kpa;

constexpr material::CamClayParameters clay{
    .compression = 0.16, .swelling = 0.03, .poisson_ratio = 0.25, .critical_state_slope = 1.1};

/// `steps` equal isotropic steps of the total volumetric strain `volume`, compression positive.
template <class Point, class Law>
void compress(Point& point, const Law& law, double volume, int steps) {
  const double part = -volume / steps / 3;
  for (int i = 0; i < steps; ++i) point.step(law, {part, part, part, 0});
}

TEST(CamClayCompression, SwellingLineIsExactInOneStep) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 40 * kpa, 0.9, 1000 * kpa);
  compress(point, law, 0.01, 1);
  EXPECT_NEAR(std::log(point.p() / (40 * kpa)), (0.9 - point.state[2]) / 0.03, 1e-5);
  EXPECT_NEAR(point.state[2], 1.9 * std::exp(-0.01) - 1, 1e-11);
  compress(point, law, -0.01, 3);
  EXPECT_NEAR(point.p(), 40 * kpa, 1);
}

TEST(CamClayCompression, NormalCompressionAndSwellingLines) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 20 * kpa, 1.2, 100 * kpa);
  compress(point, law, 0.15, 3000);
  const auto line = [](double p_c, double p) {  // e from the start, along κ to p'_c, along λ to it, along κ to p'
    return 1.2 - 0.03 * std::log(100. / 20) - 0.16 * std::log(p_c / (100 * kpa)) - 0.03 * std::log(p / p_c);
  };
  EXPECT_GT(point.p(), 300 * kpa);
  EXPECT_NEAR(point.p(), point.state[1], 1e-6 * point.p());
  EXPECT_NEAR(point.state[2], line(point.p(), point.p()), 1e-4);
  const double p_c = point.p();
  compress(point, law, -0.03, 1000);
  EXPECT_EQ(point.dissipation, 0);
  EXPECT_NEAR(point.state[2], line(p_c, point.p()), 1e-4);
}

TEST(CamClayCompression, WorkIsStoredOrDissipated) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 20 * kpa, 1.2, 50 * kpa);
  double work = 0, lost = 0;  // both, and the energy, per volume of grains
  const double stored = law.elastic_energy<4>(point.stress.data(), point.state.data()) * 2.2;
  for (int i = 0; i < 4000; ++i) {
    const double p = point.p(), e = point.state[2];
    compress(point, law, 0.1 / 4000, 1);
    const double specific = 1 + 0.5 * (e + point.state[2]);
    work += specific * 0.5 * (p + point.p()) * 0.1 / 4000;
    lost += specific * point.dissipation;
  }
  const double change = law.elastic_energy<4>(point.stress.data(), point.state.data()) * (1 + point.state[2]) - stored;
  EXPECT_GT(lost, 0.5 * work);
  EXPECT_NEAR(work, change + lost, 1e-3 * work);
}

TEST(CamClayCompression, WorkOfElasticShearIsStored) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 50 * kpa, 0.9, 500 * kpa);
  const auto energy = [&] { return law.elastic_energy<4>(point.stress.data(), point.state.data()); };
  const double before = energy();
  point.step(law, {2e-3, -2e-3, 0, 3e-3});
  EXPECT_EQ(point.dissipation, 0);
  const double work = 0.5 * ((point.stress[0] - point.stress[1]) * 2e-3 + point.stress[3] * 3e-3);
  EXPECT_NEAR(energy() - before, work, 1e-9 * work);
}

TEST(CamClayCompression, StiffnessHasAFloor) {
  const material::ModifiedCamClay law(clay);  // floor at 1 kPa
  const auto point = support::start_isotropic<4>(law, 100, 0.8, 50 * kpa);
  const double bulk = 1.8 * 1 * kpa / 0.03, shear = bulk * 3 * (1 - 2 * 0.25) / (2 * (1 + 0.25));
  EXPECT_NEAR(law.constrained_modulus(point.stress.data(), point.state.data()), bulk + 4 * shear / 3, 1e-6 * bulk);
  auto sheared = point;
  sheared.step(law, {1e-7, -1e-7, 0, 0});
  EXPECT_NEAR(sheared.stress[0] - point.stress[0], 2 * shear * 1e-7, 1e-9);
}

/// σ_h/σ_v of virgin compression without lateral strain follows from the flow rule: plastic 2η/(M²-η²), elastic by ν.
TEST(CamClayCompression, OedometerFindsTheRatioOfItsFlowRule) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 50 * kpa, 1.5, 50 * kpa);
  for (int i = 0; i < 20000; ++i) point.step(law, {0, -2e-5, 0, 0});
  const double m = 1.1, ratio = 3 * (1 - 2 * 0.25) / (2 * (1 + 0.25));  // G/K
  const auto excess = [&](double eta) {  // shear over volumetric strain, times λ, less the 2/3 of the oedometer
    return (0.03 * eta / (3 * ratio) + (0.16 - 0.03) * 2 * eta / (m * m - eta * eta)) - 0.16 * 2 / 3;
  };
  double low = 0, high = m - 1e-9;
  for (int i = 0; i < 100; ++i) (excess(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  EXPECT_NEAR(point.q() / point.p(), low, 1e-4);
  const double vertical = -point.stress[1], lateral = -point.stress[0];
  EXPECT_NEAR(lateral / vertical, (3 - low) / (3 + 2 * low), 1e-4);
  EXPECT_NEAR(point.stress[2], point.stress[0], 1e-6 * lateral);
}

/// At constant volume p' ends at p'_c/2 with (p'/p'_0) = (R/2)^Λ, Λ = (λ-κ)/λ, from both sides of the critical state.
TEST(CamClayCompression, UndrainedStrength) {
  const material::ModifiedCamClay law(clay);
  for (const double ratio : {1.0, 1.5, 4.0, 10.0}) {
    auto point = support::start_isotropic<6>(law, 100 * kpa, 0.8, 100 * kpa * ratio);
    for (int i = 0; i < 20000; ++i) point.step(law, {5e-6, -1e-5, 5e-6, 0, 0, 0});
    const double p = 100 * kpa * std::pow(ratio / 2, (0.16 - 0.03) / 0.16);
    EXPECT_NEAR(point.p(), p, 2e-3 * p) << ratio;
    EXPECT_NEAR(point.q() / 2, 1.1 * p / 2, 2e-3 * p) << ratio;  // undrained strength
    EXPECT_NEAR(point.state[1], 2 * point.p(), 4e-3 * p) << ratio;
    EXPECT_NEAR(point.state[2], 0.8, 1e-12) << ratio;
  }
}

/// The volumetric strain that leaves p' as it is, by secants.
template <class Point, class Law>
void step_at_constant_pressure(Point& point, const Law& law) {
  const double p = point.p();
  const auto excess = [&](double volume) {
    auto next = point;
    compress(next, law, volume, 1);
    return next.p() - p;
  };
  double low = -1e-2, high = 1e-2;
  for (int i = 0; i < 80; ++i) (excess(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  compress(point, law, high, 1);
}

TEST(CamClayCompression, WettingCollapsesNormallyConsolidatedSoil) {
  auto soil = clay;
  soil.suction_hardening = 4;
  const material::ModifiedCamClay law(soil);
  auto point = support::start_isotropic<4>(law, 80 * kpa, 1.0, 10 * kpa, 0, 0.6);
  EXPECT_NEAR(point.state[1], 80 * kpa * std::exp(-4 * 0.4), 1e-6);  // what p' needs
  for (int i = 0; i < 2000; ++i) {
    point.saturation += 0.4 / 2000;
    step_at_constant_pressure(point, law);
  }
  EXPECT_NEAR(point.p(), 80 * kpa, 1);
  EXPECT_NEAR(law.find_preconsolidation(point.state.data(), 1), 80 * kpa, 5);
  EXPECT_NEAR(1.0 - point.state[2], (0.16 - 0.03) * 4 * 0.4, 1e-3);
}

TEST(CamClayCompression, WettingShrinksTheEllipseOfOverconsolidatedSoilOnly) {
  auto soil = clay;
  soil.suction_hardening = 4;
  const material::ModifiedCamClay law(soil);
  auto point = support::start_isotropic<4>(law, 20 * kpa, 1.0, 100 * kpa, 0, 0.6);
  const double before = law.find_preconsolidation(point.state.data(), 0.6);
  EXPECT_NEAR(before, 100 * kpa * std::exp(1.6), 1e-6 * before);
  point.saturation = 0.9;
  point.step(law, {});
  EXPECT_NEAR(law.find_preconsolidation(point.state.data(), 0.9), before * std::exp(-4 * 0.3), 1e-6 * before);
  EXPECT_NEAR(point.p(), 20 * kpa, 1e-6);
  EXPECT_EQ(point.state[2], 1.0);
}

TEST(CamClayCompression, SoilWithoutPreconsolidationIsElastic) {
  const material::ModifiedCamClay law(clay);
  auto point = support::start_isotropic<4>(law, 20 * kpa, 1.0, law.not_set);
  for (int i = 0; i < 100; ++i) point.step(law, {-1e-3, 1e-3, 0, 2e-3});
  EXPECT_EQ(point.dissipation, 0);
  EXPECT_EQ(point.state[0], 0);
  EXPECT_GE(point.state[1], 1e29);
  point.state[1] = law.not_set / 3;  // a mean over three points, of which one is not set yet
  point.step(law, {-1e-3, 1e-3, 0, 2e-3});
  EXPECT_EQ(point.dissipation, 0);
}

}  // namespace
