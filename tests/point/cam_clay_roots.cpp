// SPDX-License-Identifier: MIT
// Effects of roots on Cam-clay: larger p'_c and M, hardening with the activation strain, breakage, and the mechanics of
// Figure 4.2 of the source, each against a closed form or a limit.

#include <gtest/gtest.h>

#include "support/clay_point.hpp"

namespace {

using namespace talus;
using support::kpa;

constexpr material::CamClayParameters clay{
    .compression = 0.12, .swelling = 0.02, .poisson_ratio = 0.3, .critical_state_slope = 1.0};

TEST(CamClayRoots, StartWithALargerEllipse) {
  auto soil = clay;
  soil.suction_hardening = 5;
  const material::RootedCamClay law(soil, {.hardening = 0.4, .strength = 0.18});
  const auto point = support::start_isotropic<4>(law, 10 * kpa, 0.8, 30 * kpa, 1.29, 0.8);
  EXPECT_NEAR(law.find_preconsolidation(point.state.data(), 0.8), 30 * kpa * std::exp(5 * 0.2 + 0.4 * 1.29), 1e-6);
  const auto loaded = support::start_isotropic<4>(law, 500 * kpa, 0.8, 30 * kpa, 1.29, 0.8);
  EXPECT_NEAR(law.find_preconsolidation(loaded.state.data(), 0.8), 500 * kpa, 1e-3);  // max(p'_cn, p'_0)
}

/// Roots without effect leave the stress of modified Cam-clay bitwise identical.
TEST(CamClayRoots, WithoutContentAreBareSoil) {
  const material::RootedCamClay rooted(clay, {.hardening = 0.4, .strength = 0.18});
  const material::ModifiedCamClay bare(clay);
  auto a = support::start_isotropic<4>(rooted, 50 * kpa, 0.8, 60 * kpa, 0);
  auto b = support::start_isotropic<4>(bare, 50 * kpa, 0.8, 60 * kpa);
  for (int i = 0; i < 500; ++i) {
    a.step(rooted, {1e-5, -1e-4, 0, 1e-4});
    b.step(bare, {1e-5, -1e-4, 0, 1e-4});
  }
  EXPECT_GT(b.dissipation, 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a.stress[i], b.stress[i], 1e-6);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.state[i], b.state[i], 1e-9 * b.state[i]);
}

/// Isotropic compression: activation is the volumetric strain, so ln p'_c grows with plastic volume and with ∫e dε_v.
TEST(CamClayRoots, IsotropicCompressionLine) {
  const material::RootedCamClay law(clay, {.hardening = 0.5});
  auto point = support::start_isotropic<4>(law, 100 * kpa, 1.0, 10 * kpa, 1.5);
  for (int i = 0; i < 4000; ++i) point.step(law, {-1e-5, -1e-5, -1e-5, 0});
  // λ d ln p' = -de + (λ-κ) a e dε_v with a = R_p m_r
  const double from = 1.0, to = point.state[2], a = 0.5 * 1.5;
  const double rise = ((from - to) + (0.12 - 0.02) * a * ((from - to) - std::log((1 + from) / (1 + to)))) / 0.12;
  EXPECT_NEAR(std::log(point.p() / (100 * kpa)), rise, 1e-3 * rise);
  EXPECT_NEAR(point.state[5], 0.12, 1e-9);
}

/// Figure 4.2: 10 % of roots, R_p from 0 to 10 with the fraction in (4.6) and m_r left out of (4.10). Undrained, p' and
/// q then grow without limit: d ln p'/dε_q = Λ R_p e, at a ratio η > M that keeps p'_c/p' constant while the plastic
/// volume change compensates the elastic one.
TEST(CamClayRoots, UndrainedShearingGrowsAsActivationDoes) {
  double before = 0;
  for (const double r_p : {0.0, 2.0, 5.0, 10.0}) {
    const material::RootedCamClay law(clay, {.hardening = r_p / 100, .activation = r_p});
    auto point = support::start_isotropic<6>(law, 100 * kpa, 0.7, 100 * kpa, 10);
    EXPECT_NEAR(law.find_preconsolidation(point.state.data(), 1), 100 * kpa * std::exp(0.1 * r_p), 1e-6);
    double p = 0;
    for (int i = 0; i < 25000; ++i) {
      if (i == 20000) p = point.p();
      point.step(law, {5e-6, -1e-5, 5e-6, 0, 0, 0});
    }
    const double growth = (0.12 - 0.02) / 0.12 * r_p * 0.7;
    EXPECT_NEAR(std::log(point.p() / p) / 0.05, growth, 0.01 * growth + 1e-3) << r_p;
    const double ratio = 3 * (1 - 2 * 0.3) / (2 * (1 + 0.3)), eta = point.q() / point.p();
    const double shear = 1 - eta * 0.02 * growth / (3 * ratio * 1.7);  // plastic fraction of the shear strain
    EXPECT_NEAR((1 - eta * eta) / (2 * eta) * shear, -0.02 * growth / 1.7, 2e-3) << r_p;
    EXPECT_GT(point.q(), before);
    before = point.q();
  }
}

/// Drained at constant p' the volume comes to rest; q/p' = M_0 + R_a m_r.
TEST(CamClayRoots, RaiseTheCriticalState) {
  const material::RootedCamClay law(clay, {.strength = 0.2});
  auto point = support::start_isotropic<6>(law, 100 * kpa, 0.7, 100 * kpa, 1.5);
  for (int i = 0; i < 20000; ++i) support::step_triaxial(law, point, 5e-5, 100 * kpa);
  EXPECT_NEAR(point.q() / point.p(), 1.0 + 0.2 * 1.5, 2e-3);
}

/// Beyond the peak roots break linearly with ε_r, do not recover, and leave the strength of bare soil.
TEST(CamClayRoots, BreakAndStayBroken) {
  const material::RootedCamClay law(
      clay,
      {.hardening = 0.4, .strength = 0.2, .breaking_strain = 0.05, .breaking_range = 0.1, .residual_share = 0.25});
  auto point = support::start_isotropic<6>(law, 100 * kpa, 0.7, 100 * kpa, 1.5);
  double least = 1;
  for (int i = 0; i < 16000; ++i) {
    support::step_triaxial(law, point, 5e-5, 100 * kpa);
    const double expected = 0.25 + 0.75 * std::clamp(1 - (point.state[5] - 0.05) / 0.1, 0.0, 1.0);
    least = std::min(least, expected);
    ASSERT_NEAR(point.state[6], least, 1e-12);
  }
  EXPECT_EQ(point.state[6], 0.25);
  // the intact roots continue to harden, and p'_c is constant only if dilatancy softens as much
  const double m = 1.0 + 0.25 * 0.2 * 1.5, eta = point.q() / point.p(), e = point.state[2];
  const double roots = 0.25 * 0.4 * 1.5 * e, plastic = (1 + e) / (0.12 - 0.02);
  EXPECT_NEAR((m * m - eta * eta) / (2 * eta), -roots / (plastic + roots), 1e-3);
  for (int i = 0; i < 4000; ++i) point.step(law, {1e-4, 1e-4, 1e-4, 0, 0, 0});  // swelling takes ε_r back
  EXPECT_LT(point.state[5], 0.05);
  EXPECT_EQ(point.state[6], 0.25);
}

TEST(CamClayRoots, PartlyBrokenSoftenAfterAPeak) {
  const material::RootedCamClay law(clay, {.hardening = 0.4, .strength = 0.2, .breaking_strain = 0.1});
  auto point = support::start_isotropic<6>(law, 100 * kpa, 0.7, 100 * kpa, 1.5);
  double peak = 0;
  for (int i = 0; i < 20000; ++i) {
    support::step_triaxial(law, point, 5e-5, 100 * kpa);
    peak = std::max(peak, point.q());
  }
  const double bare = 3 * 1.0 / (3 - 1.0) * 100 * kpa;  // q of the critical state at constant radial stress
  EXPECT_GT(peak, 1.02 * bare);
  EXPECT_NEAR(point.q(), bare, 0.005 * bare);
}

/// tan φ mobilised at the critical state of triaxial compression is divided by the factor, with roots and without.
TEST(CamClayRoots, StrengthFactorDividesTheTangent) {
  const auto find_tangent = [](double factor, double content) {
    auto soil = clay;
    soil.strength_factor = factor;
    const material::RootedCamClay law(soil, {.strength = 0.2});
    auto point = support::start_isotropic<6>(law, 100 * kpa, 0.7, 100 * kpa, content);
    for (int i = 0; i < 20000; ++i) support::step_triaxial(law, point, 5e-5, 100 * kpa);
    const double sine = (point.stress[0] - point.stress[1]) / -(point.stress[0] + point.stress[1]);
    return sine / std::sqrt(1 - sine * sine);
  };
  for (const double content : {0.0, 1.5})
    EXPECT_NEAR(find_tangent(1.4, content), find_tangent(1, content) / 1.4, 2e-3) << content;
}

/// Nothing of the roots moves before the soil has a preconsolidation.
TEST(CamClayRoots, WaitForThePreconsolidation) {
  const material::RootedCamClay law(clay, {.hardening = 0.4, .breaking_strain = 0});
  auto point = support::start_isotropic<4>(law, 50 * kpa, 0.8, law.not_set, 1);
  for (int i = 0; i < 10; ++i) point.step(law, {1e-4, -1e-3, 0, 0});
  EXPECT_EQ(point.state[5], 0);
  EXPECT_EQ(point.state[4], 0.4);
  EXPECT_EQ(point.state[6], 1);
}

}  // namespace
