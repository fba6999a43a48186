// SPDX-License-Identifier: MIT
// Mohr–Coulomb soil that softens with plastic shear strain, at a point.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/hoek_brown.hpp"
#include "material/softening.hpp"
#include "support/soil_point.hpp"

namespace talus {
namespace {

using support::Voigt;
constexpr double degree = std::numbers::pi / 180;

struct Blocks : material::YoungInput,
                material::PoissonInput,
                material::MohrCoulombStrength,
                material::ResidualStrength,
                material::SofteningRange {};

Blocks make_clay() {
  Blocks in;
  in.young_modulus = 20e6, in.poisson_ratio = 0.3;
  static_cast<material::MohrCoulombStrength&>(in) = {20e3, 24 * degree, 6 * degree, 2e3};
  static_cast<material::ResidualStrength&>(in) = {4e3, 12 * degree};
  static_cast<material::SofteningRange&>(in) = {0.01, 0.2, material::LimitStrength::residual};
  return in;
}

/// Shears at constant volume; calls see(stress, state) after every step.
void shear(const material::SofteningMohrCoulomb& law, int steps, double step, auto&& see) {
  Voigt<4> stress{-200e3, -200e3, -200e3, 0}, d{step, -step, 0, 0};
  std::array<double, 3> state{};
  for (int i = 0; i < steps; ++i) {
    const double softening_strain = state[1];
    law.update<4>(stress.data(), d.data(), state.data(), true);
    see(stress, state, softening_strain);
  }
}

TEST(SofteningMohrCoulomb, HasTheStrengthOfItsStrain) {
  const auto law = material::SofteningMohrCoulomb::make(make_clay(), {});
  int peak = 0, falling = 0, residual = 0;
  shear(law, 60000, 1e-5, [&](const Voigt<4>& s, const std::array<double, 3>& state, double before) {
    if (!(state[0] > 0)) return;
    // By hand: c and tan φ are linear between 0.01 and 0.2.
    const double share = before < 0.01 ? 0 : before > 0.2 ? 1 : (before - 0.01) / 0.19;
    const double c = 20e3 - share * 16e3,
                 tangent = std::tan(24 * degree) + share * (std::tan(12 * degree) - std::tan(24 * degree)),
                 phi = std::atan(tangent), radius = std::hypot(0.5 * (s[0] - s[1]), s[3]);
    EXPECT_NEAR(radius, c * std::cos(phi) - 0.5 * (s[0] + s[1]) * std::sin(phi), 1e-9 * radius);
    (share == 0 ? peak : share == 1 ? residual : falling) += 1;
  });
  EXPECT_GT(peak, 100);
  EXPECT_GT(falling, 100);
  EXPECT_GT(residual, 100);
}

TEST(SofteningMohrCoulomb, IsDividedByTheFactorAtEveryStrain) {
  const Blocks in = make_clay();
  const auto law = material::SofteningMohrCoulomb::make(in, {1.25, {}}),
             whole = material::SofteningMohrCoulomb::make(in, {});
  for (const double strain : {0.0, 0.05, 0.15, 0.4}) {
    const auto reduced = law.find_strength(strain), full = whole.find_strength(strain);
    EXPECT_NEAR(reduced.cohesion, full.cohesion / 1.25, 1e-9 * full.cohesion);
    EXPECT_NEAR(std::tan(reduced.friction_angle), std::tan(full.friction_angle) / 1.25, 1e-12);
  }
}

TEST(SofteningMohrCoulomb, SoftensByTheNonlocalStrain) {
  const auto law = material::SofteningMohrCoulomb::make(make_clay(), {});
  Voigt<4> stress{-200e3, -200e3, -200e3, 0};
  const Voigt<4> d{1e-3, -1e-3, 0, 0};
  std::array<double, 3> state{0.05, 0.05, 0};
  material::Softening<double> softening{0.03, 0};
  material::Surroundings<double> around;
  around.softening = &softening;
  for (int i = 0; i < 20; ++i) {
    const double local = state[0], before = state[1];
    law.update<4>(stress.data(), d.data(), state.data(), true, around);
    EXPECT_NEAR(state[1] - before, softening.nonlocal_correction + state[0] - local, 1e-12);
    EXPECT_NEAR(softening.softened, state[0] - local, 1e-15) << "what neighbours average";
    softening.nonlocal_correction = 0;
  }
  EXPECT_GT(state[0], 0.06);
}

TEST(SofteningMohrCoulomb, WithoutSofteningIsMohrCoulomb) {
  Blocks in = make_clay();
  in.residual_cohesion = in.cohesion, in.residual_friction_angle = in.friction_angle;
  in.softening_start = 100, in.softening_end = 101;
  const auto law = material::SofteningMohrCoulomb::make(in, {});
  const material::MohrCoulomb plain(material::LinearElastic::from_young(20e6, 0.3), in);
  Voigt<4> other{-200e3, -200e3, -200e3, 0};
  std::array<double, 2> plain_state{};
  shear(law, 3000, 1e-5, [&](const Voigt<4>& s, const std::array<double, 3>& state, double) {
    const Voigt<4> d{1e-5, -1e-5, 0, 0};
    plain.update<4>(other.data(), d.data(), plain_state.data(), true);
    for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(s[i], other[i]);
    ASSERT_EQ(state[0], plain_state[0]);
  });
}

TEST(SofteningHoekBrown, FollowsTheCriterionOfItsIndex) {
  struct Rock : material::YoungInput,
                material::PoissonInput,
                material::HoekBrownInput,
                material::ResidualIndex,
                material::SofteningRange,
                material::FlowRatio {};
  Rock in;
  in.young_modulus = 5e8, in.poisson_ratio = 0.3;
  static_cast<material::HoekBrownInput&>(in) = {30e6, 40, 10, 0};
  in.residual_gsi = 15;
  static_cast<material::SofteningRange&>(in) = {0.01, 0.1, material::LimitStrength::peak};
  const auto law = material::SofteningHoekBrown::make(in, {});
  Voigt<4> s{-1e6, -1e6, -1e6, 0};
  const Voigt<4> d{2e-5, -2e-5, 0, 0};
  std::array<double, 3> state{};
  int falling = 0;
  for (int i = 0; i < 8000; ++i) {
    const double before = state[1], local = state[0];
    law.update<4>(s.data(), d.data(), state.data(), true);
    if (!(state[0] > local)) continue;
    const double share = std::clamp((before - 0.01) / 0.09, 0.0, 1.0);
    const material::HoekBrownMass mass = material::make_rock_mass({30e6, 40 - 25 * share, 10, 0});
    const double minor = -std::max({s[0], s[1], s[2]}), major = -std::min({s[0], s[1], s[2]});
    EXPECT_NEAR(major, mass.find_major(minor), 1e-6 * major);
    falling += share > 0 && share < 1;
  }
  EXPECT_GT(falling, 100);
  EXPECT_GT(state[1], 0.1);
}

}  // namespace
}  // namespace talus
