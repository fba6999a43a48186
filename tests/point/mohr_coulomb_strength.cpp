// SPDX-License-Identifier: MIT
// Strength and flow of Mohr–Coulomb soil in element tests, against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/soil_point.hpp"

namespace talus {
namespace {

using support::drive;
using support::find_plastic_strain;
using support::Soil;
using support::Voigt;

constexpr double degree = std::numbers::pi / 180;

const std::vector<Soil> soils = {
    {.cohesion = 5e3, .friction = 30 * degree, .dilatancy = 10 * degree},
    {.cohesion = 20e3, .friction = 20 * degree, .dilatancy = 20 * degree},
    {.cohesion = 1e3, .friction = 38 * degree, .dilatancy = 0},
    {.cohesion = 0, .friction = 33 * degree, .dilatancy = 5 * degree},
    {.cohesion = 15e3, .friction = 0, .dilatancy = 0},
};

/// N_φ of Rankine's earth pressures.
double passive_ratio(double phi) {
  return (1 + std::sin(phi)) / (1 - std::sin(phi));
}

/// A drained triaxial test on a point: axial strain is imposed in steps and the radial strain found by Newton's secant
/// so that the cell pressure stays. Returns the stress at the end; `plastic` becomes the last increment's plastic
/// strain.
Voigt<6> run_triaxial(const Soil& soil, double cell_pressure, double axial_step, int steps, reference::Tensor& plastic,
                      double& accumulated) {
  const auto law = soil.law();
  Voigt<6> stress{-cell_pressure, -cell_pressure, -cell_pressure, 0, 0, 0};
  accumulated = 0;
  for (int n = 0; n < steps; ++n) {
    const auto radial_error = [&](double radial) {
      return drive<6>(law, stress, {radial, axial_step, radial, 0, 0, 0}).stress[0] + cell_pressure;
    };
    double a = -soil.poisson_ratio * axial_step, b = a - 0.1 * axial_step;
    double fa = radial_error(a), fb = radial_error(b);
    for (int i = 0; i < 60 && std::abs(fb) > 1e-9 * cell_pressure && fb != fa; ++i) {
      const double c = b - fb * (b - a) / (fb - fa);
      a = b, fa = fb;
      b = c, fb = radial_error(c);
    }
    const Voigt<6> d{b, axial_step, b, 0, 0, 0};
    const auto o = drive<6>(law, stress, d);
    EXPECT_NEAR(o.stress[0], -cell_pressure, 1e-7 * cell_pressure);
    plastic = find_plastic_strain<6>(soil, stress, d, o.stress);
    accumulated += o.plastic_strain;
    stress = o.stress;
  }
  return stress;
}

TEST(MohrCoulombStrength, DrainedTriaxialCompressionFailsAtThePassiveStress) {
  for (const Soil& soil : soils) {
    reference::Tensor plastic;
    double accumulated = 0;
    const double p = 100e3, n = passive_ratio(soil.friction);
    const Voigt<6> end = run_triaxial(soil, p, -5e-4, 80, plastic, accumulated);
    EXPECT_NEAR(-end[1], n * p + 2 * soil.cohesion * std::sqrt(n), 1e-6 * p) << soil.friction;
    // ε_v^p/ε_1^p of the edge of triaxial compression: 1 - (1+sinψ)/(1-sinψ)
    EXPECT_NEAR(plastic.trace() / plastic(1, 1), 1 - passive_ratio(soil.dilatancy), 1e-5) << soil.dilatancy;
    EXPECT_GT(accumulated, 0.02);
  }
}

TEST(MohrCoulombStrength, DrainedTriaxialExtensionFailsAtTheActiveStress) {
  for (const Soil& soil : soils) {
    reference::Tensor plastic;
    double accumulated = 0;
    const double p = 100e3, n = passive_ratio(soil.friction);
    const Voigt<6> end = run_triaxial(soil, p, 5e-4, 80, plastic, accumulated);
    EXPECT_NEAR(-end[1], (p - 2 * soil.cohesion * std::sqrt(n)) / n, 1e-6 * p) << soil.friction;
    // the axis lengthens, both radii shorten: ε_v^p/ε_a^p = 1 - (1-sinψ)/(1+sinψ)
    EXPECT_NEAR(plastic.trace() / plastic(1, 1), 1 - 1 / passive_ratio(soil.dilatancy), 1e-5) << soil.dilatancy;
  }
}

TEST(MohrCoulombStrength, PlaneStrainShearFailsAtCoulombsStrengthAndDilatesWithPsi) {
  for (const Soil& soil : soils) {
    const auto law = soil.law();
    const double p = 80e3;
    // Biaxial: the mean of the in-plane stresses is kept, so Mohr's radius at failure is p sinφ + c cosφ.
    Voigt<4> stress{-p, -p, -p, 0};
    reference::Tensor plastic;
    for (int n = 0; n < 60; ++n) {
      const auto error = [&](double v) {
        const auto s = drive<4>(law, stress, {v - 2e-4, v + 2e-4, 0, 3e-4}).stress;
        return 0.5 * (s[0] + s[1]) + p;
      };
      double a = 0, b = 1e-5, fa = error(a), fb = error(b);
      for (int i = 0; i < 60 && std::abs(fb) > 1e-9 * p && fb != fa; ++i) {
        const double c = b - fb * (b - a) / (fb - fa);
        a = b, fa = fb;
        b = c, fb = error(c);
      }
      const Voigt<4> d{b - 2e-4, b + 2e-4, 0, 3e-4};
      const auto o = drive<4>(law, stress, d);
      plastic = find_plastic_strain<4>(soil, stress, d, o.stress);
      stress = o.stress;
    }
    const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[3]);
    EXPECT_NEAR(radius, p * std::sin(soil.friction) + soil.cohesion * std::cos(soil.friction), 1e-6 * p);
    const double shear = std::hypot(plastic(0, 0) - plastic(1, 1), 2 * plastic(0, 1));
    EXPECT_NEAR((plastic(0, 0) + plastic(1, 1)) / shear, std::sin(soil.dilatancy), 1e-6);
    EXPECT_NEAR(plastic(2, 2), 0, 1e-9);
  }
}

TEST(MohrCoulombStrength, IsotropicTensionEndsAtTheApex) {
  for (const Soil& soil : soils) {
    if (soil.friction == 0) continue;
    const auto law = soil.law();
    const double apex = soil.cohesion / std::tan(soil.friction), stretch = 0.01;
    const auto space = drive<6>(law, {-1e3, -1e3, -1e3, 0, 0, 0}, {stretch, stretch, stretch, 0, 0, 0});
    const auto plane = drive<4>(law, {-1e3, -1e3, -1e3, 0}, {stretch, stretch, stretch, 0});
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(space.stress[i], apex, 1e-3);
      EXPECT_NEAR(plane.stress[i], apex, 1e-3);
    }
    const double bulk = soil.young_modulus / (3 * (1 - 2 * soil.poisson_ratio));
    EXPECT_NEAR(space.plastic_dilation, 3 * stretch - (apex + 1e3) / bulk, 1e-3 / bulk);
    EXPECT_NEAR(space.plastic_strain, 0, 1e-9) << "isotropic flow has no deviatoric part";
  }
}

TEST(MohrCoulombStrength, CutOffHoldsOneTwoOrThreePrincipalStressesAtTheTensileStrength) {
  const Soil soil{.cohesion = 20e3, .friction = 25 * degree, .dilatancy = 5 * degree, .tensile_strength = 2e3};
  const auto law = soil.law();
  const double nu = soil.poisson_ratio;
  const auto one = drive<6>(law, {0, -8e3, -10e3, 0, 0, 0}, {2e-4, 0, 0, 0, 0, 0}).stress;
  EXPECT_NEAR(one[0], 2e3, 1e-4);
  EXPECT_NEAR(one[1], -8e3 + nu / (1 - nu) * 2e3, 1e-4);  // elastic strain of ε_xx alone, with σ_xx = 2 kPa
  EXPECT_NEAR(one[2], -10e3 + nu / (1 - nu) * 2e3, 1e-4);
  const auto two = drive<6>(law, {0, 0, -10e3, 0, 0, 0}, {2e-4, 3e-4, 0, 0, 0, 0}).stress;
  EXPECT_NEAR(two[0], 2e3, 1e-4);
  EXPECT_NEAR(two[1], 2e3, 1e-4);
  EXPECT_NEAR(two[2], -10e3 + nu * 4e3, 1e-4);  // Hooke with ε_zz^e = 0
  const auto three = drive<6>(law, {0, 0, 0, 0, 0, 0}, {2e-3, 3e-3, 2.5e-3, 0, 0, 0}).stress;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(three[i], 2e3, 1e-4);
}

TEST(MohrCoulombStrength, TensileStrengthAboveTheApexHasNoEffect) {
  Soil soil{.cohesion = 4e3, .friction = 30 * degree, .dilatancy = 3 * degree, .tensile_strength = 1e9};
  Soil apex = soil;
  apex.tensile_strength = soil.cohesion / std::tan(soil.friction);
  for (double y : {-3e-3, 0.0, 1e-3, 3e-3}) {
    const Voigt<6> d{2e-3, y, 5e-4, 1e-3, 0, 2e-4};
    const auto a = drive<6>(soil.law(), {}, d), b = drive<6>(apex.law(), {}, d);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(a.stress[i], b.stress[i], 1e-5);
  }
}

TEST(MohrCoulombStrength, UndrainedSoilIsLimitedByTwiceItsCohesionAndKeepsItsMeanStress) {
  const Soil soil{.cohesion = 10e3, .friction = 0, .dilatancy = 0};
  const double bulk = soil.young_modulus / (3 * (1 - 2 * soil.poisson_ratio));
  const auto o = drive<6>(soil.law(), {-30e3, -30e3, -30e3, 0, 0, 0}, {0.01, -0.02, 0.003, 0, 0, 0});
  EXPECT_NEAR(o.stress[0] - o.stress[1], 20e3, 1e-4);
  EXPECT_NEAR((o.stress[0] + o.stress[1] + o.stress[2]) / 3, -30e3 + bulk * -0.007, 1e-4);
  EXPECT_NEAR(o.plastic_dilation, 0, 1e-4 / bulk);
  const auto shear = drive<4>(soil.law(), {-5e3, -5e3, -5e3, 0}, {0, 0, 0, 0.02});
  EXPECT_NEAR(shear.stress[3], 10e3, 1e-4);
}

TEST(MohrCoulombStrength, CohesionlessSoilTakesNoTensionAndSlidesAtPhi) {
  const Soil soil{.cohesion = 0, .friction = 35 * degree, .dilatancy = 0};
  const auto torn = drive<4>(soil.law(), {-1e3, -1e3, -1e3, 0}, {0.01, 0.01, 0, 0.005});
  for (double s : torn.stress) EXPECT_NEAR(s, 0, 1e-4);
  const auto sheared = drive<4>(soil.law(), {-1e4, -1e4, -1e4, 0}, {0, 0, 0, 0.05});
  EXPECT_NEAR(sheared.stress[3], 1e4 * std::sin(soil.friction), 1e-4);
}

TEST(MohrCoulombStrength, ReductionDividesCohesionAndTanPhi) {
  const material::MohrCoulombStrength s{12e3, 30 * degree, 20 * degree, 6e3};
  for (double f : {0.8, 1.0, 1.35, 2.0}) {
    const auto r = s.reduced(f);
    EXPECT_NEAR(r.cohesion, 12e3 / f, 1e-9);
    EXPECT_NEAR(std::tan(r.friction_angle), std::tan(30 * degree) / f, 1e-14);
    EXPECT_NEAR(r.tensile_strength, 6e3 / f, 1e-9);
    EXPECT_LE(r.dilatancy_angle, r.friction_angle);
    EXPECT_NEAR(r.dilatancy_angle, std::min(20 * degree, r.friction_angle), 1e-14);
  }
}

TEST(MohrCoulombStrength, ReducedSoilFailsAtItsStrengthDividedByTheFactor) {
  // Coulomb's line is scaled as a whole: at the same normal stress on the plane of failure the shear is τ/F.
  const Soil soil{.cohesion = 8e3, .friction = 28 * degree, .dilatancy = 0};
  const double f = 1.4;
  const auto weak = material::MohrCoulomb(soil.elastic(), soil.law().strength().reduced(f));
  const auto s = drive<4>(weak, {-50e3, -50e3, -50e3, 0}, {0, 0, 0, 0.05}).stress;
  const double mean = -0.5 * (s[0] + s[1]), radius = std::hypot(0.5 * (s[0] - s[1]), s[3]);
  const double phi = std::atan(std::tan(soil.friction) / f);
  const double normal = mean - radius * std::sin(phi), tau = radius * std::cos(phi);
  EXPECT_NEAR(tau, (soil.cohesion + normal * std::tan(soil.friction)) / f, 1e-4);
}

}  // namespace
}  // namespace talus
