// SPDX-License-Identifier: MIT
// The plain Mohr–Coulomb return mapping against closed forms and the principle of maximum plastic work.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "reference/plain_material.hpp"

namespace talus::reference {
namespace {

Material make_soil(double cohesion, double phi, double psi, double tensile_strength) {
  return {.young_modulus = 20e6,
          .poisson_ratio = 0.3,
          .plastic = true,
          .cohesion = cohesion,
          .friction_angle = phi,
          .dilatancy_angle = psi,
          .tensile_strength = tensile_strength};
}

Tensor diagonal(double x, double y, double z) {
  return Vector3(x, y, z).asDiagonal();
}

/// Plastic strain of an increment: what elasticity does not explain.
Tensor plastic_strain(const Material& m, const Tensor& before, const Tensor& increment, const Tensor& after) {
  const Tensor change = after - before;
  const Tensor elastic = (1 + m.poisson_ratio) / m.young_modulus * change -
                         m.poisson_ratio / m.young_modulus * change.trace() * Tensor::Identity();
  return increment - elastic;
}

TEST(ReferenceMohrCoulomb, TriaxialCompressionEndsAtThePassiveStressWithItsDilatancy) {
  const Material m = make_soil(5e3, 0.5, 0.2, 1e9);
  const Tensor before = diagonal(-100e3, -100e3, -100e3), increment = diagonal(0.008, -0.02, 0.008);
  const Tensor after = update_stress(m, before, increment).sigma;
  const double n = (1 + std::sin(0.5)) / (1 - std::sin(0.5));
  EXPECT_NEAR(after(1, 1), n * after(0, 0) - 2 * 5e3 * std::sqrt(n), 1e-6);
  EXPECT_NEAR(after(0, 0), after(2, 2), 1e-6);
  const Tensor plastic = plastic_strain(m, before, increment, after);
  EXPECT_NEAR(plastic(0, 0) / plastic(1, 1), -(1 + std::sin(0.2)) / (2 * (1 - std::sin(0.2))), 1e-9);
}

TEST(ReferenceMohrCoulomb, TriaxialExtensionEndsAtTheActiveStressWithItsDilatancy) {
  const Material m = make_soil(5e3, 0.5, 0.2, 1e9);
  const Tensor before = diagonal(-100e3, -100e3, -100e3), increment = diagonal(-0.004, 0.006, -0.004);
  const StressUpdate update = update_stress(m, before, increment);
  const Tensor& after = update.sigma;
  const double n = (1 + std::sin(0.5)) / (1 - std::sin(0.5));
  EXPECT_NEAR(after(0, 0), n * after(1, 1) - 2 * 5e3 * std::sqrt(n), 1e-6);
  const Tensor plastic = plastic_strain(m, before, increment, after);
  EXPECT_NEAR(plastic(0, 0) / plastic(1, 1), -(1 - std::sin(0.2)) / (2 * (1 + std::sin(0.2))), 1e-9);
  // Axisymmetric: sqrt(2/3 e:e) is the difference of axial and radial strain times 2/3.
  EXPECT_NEAR(update.plastic_strain, 2.0 / 3 * (plastic(1, 1) - plastic(0, 0)), 1e-12);
}

TEST(ReferenceMohrCoulomb, PlaneStrainShearWithoutDilatancyKeepsTheMeanStressAndTheOutOfPlaneStress) {
  const double c = 3e3, phi = 0.45, p0 = 50e3;
  const Material m = make_soil(c, phi, 0, 1e9);
  Tensor increment = Tensor::Zero();
  increment(0, 1) = increment(1, 0) = 0.05;
  const StressUpdate update = update_stress(m, -p0 * Tensor::Identity(), increment);
  EXPECT_NEAR(update.sigma(0, 1), p0 * std::sin(phi) + c * std::cos(phi), 1e-6);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(update.sigma(d, d), -p0, 1e-6);
  EXPECT_NEAR(update.plastic.trace(), 0, 1e-12);
}

TEST(ReferenceMohrCoulomb, StrongTensionEndsAtTheApexAlsoWithoutDilatancy) {
  const double c = 4e3, phi = 0.4;
  for (double psi : {0.0, 0.1, 0.4}) {
    const StressUpdate update =
        update_stress(make_soil(c, phi, psi, 1e9), Tensor::Zero(), diagonal(0.01, 0.0101, 0.0099));
    EXPECT_LT((update.sigma - c / std::tan(phi) * Tensor::Identity()).norm(), 1e-6) << "psi = " << psi;
  }
}

TEST(ReferenceMohrCoulomb, TensionCutOffLimitsOneTwoOrThreePrincipalStresses) {
  const Material m = make_soil(20e3, 0.4, 0.1, 2e3);
  const Tensor all = update_stress(m, Tensor::Zero(), diagonal(0.01, 0.01, 0.01)).sigma;
  EXPECT_LT((all - 2e3 * Tensor::Identity()).norm(), 1e-6);
  // One plane: the closed form is λ = (σ1 − σ_t)/E_c, which takes ν/(1−ν) of it from the two other directions.
  const Tensor before = diagonal(0, -8e3, -10e3);
  const Tensor one = update_stress(m, before, diagonal(2e-4, 0, 0)).sigma;
  const double constrained = 20e6 * 0.7 / (1.3 * 0.4), surplus = constrained * 2e-4 - 2e3, fraction = 0.3 / 0.7;
  EXPECT_NEAR(one(0, 0), 2e3, 1e-6);
  EXPECT_NEAR(one(1, 1), -8e3 + fraction * 2e3, 1e-6);
  EXPECT_NEAR(one(2, 2), -10e3 + fraction * 2e3, 1e-6);
  ASSERT_GT(surplus, 0);
  const Tensor two = update_stress(m, diagonal(0, 0, -10e3), diagonal(2e-4, 3e-4, 0)).sigma;
  EXPECT_NEAR(two(0, 0), 2e3, 1e-6);
  EXPECT_NEAR(two(1, 1), 2e3, 1e-6);
  EXPECT_NEAR(two(2, 2), -10e3 + 0.3 * 4e3, 1e-6);  // ε_zz^e = 0 and two stresses of σ_t: Hooke's law gives 2νσ_t
}

TEST(ReferenceMohrCoulomb, TrescaSoilIsLimitedByTwiceItsCohesion) {
  const Material m = make_soil(10e3, 0, 0, 1e9);
  const Tensor sigma = update_stress(m, -30e3 * Tensor::Identity(), diagonal(0.01, -0.02, 0.003)).sigma;
  EXPECT_NEAR(sigma(0, 0) - sigma(1, 1), 2 * 10e3, 1e-6);
  EXPECT_NEAR(sigma.trace() / 3, -30e3 + 20e6 / (3 * 0.4) * -0.007, 1e-5);
}

TEST(ReferenceMohrCoulomb, RotatingTheTrialRotatesTheResult) {
  const Material m = make_soil(5e3, 0.5, 0.1, 3e3);
  const Tensor q = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const Tensor before = diagonal(-20e3, -35e3, -25e3), increment = diagonal(2e-3, -4e-3, 1e-3);
  const StressUpdate straight = update_stress(m, before, increment);
  const StressUpdate turned = update_stress(m, q * before * q.transpose(), q * increment * q.transpose());
  ASSERT_GT(straight.plastic_strain, 0);
  EXPECT_LT((turned.sigma - q * straight.sigma * q.transpose()).norm(), 1e-6);
  EXPECT_NEAR(turned.plastic_strain, straight.plastic_strain, 1e-12);
}

/// Random ordered principal stresses and soils.
class RandomReturns : public ::testing::Test {
 protected:
  double draw(double from, double to) {
    return from + (to - from) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }
  Material draw_soil(bool associated) {
    const double phi = draw(0.05, 0.8), c = draw(0, 20e3);
    const double apex = c / std::tan(phi);
    return make_soil(c, phi, associated ? phi : draw(0, phi), draw(0, 1.3) * apex);
  }
  Vector3 draw_ordered(double from, double to) {
    Vector3 s(draw(from, to), draw(from, to), draw(from, to));
    std::sort(s.begin(), s.end(), std::greater<>());
    return s;
  }
  static double find_largest_violation(const Material& m, const Vector3& s) {
    const double sine = std::sin(m.friction_angle), strength = 2 * m.cohesion * std::cos(m.friction_angle);
    return std::max(
        {s[0] - s[2] + (s[0] + s[2]) * sine - strength, s[0] - m.tensile_strength, s[1] - s[0], s[2] - s[1]});
  }

 private:
  std::mt19937 random_{7};
};

TEST_F(RandomReturns, EveryAdmissibleSetOfPlanesGivesTheSameStress) {
  for (int i = 0; i < 20000; ++i) {
    const Material m = draw_soil(false);
    const Vector3 trial = draw_ordered(-200e3, 80e3);
    const Vector3 chosen = return_principal(m, trial);
    for (int count = 0; count <= 3; ++count)
      for (const Vector3& other : find_returns(m, trial, count))
        ASSERT_LT((other - chosen).norm(), 1e-3)
            << "trial " << trial.transpose() << ", c " << m.cohesion << ", phi " << m.friction_angle << ", psi "
            << m.dilatancy_angle << ", sigma_t " << m.tensile_strength << ", planes " << count;
  }
}

TEST_F(RandomReturns, TheResultIsAdmissibleAndOrdered) {
  for (int i = 0; i < 20000; ++i) {
    const Material m = draw_soil(false);
    const Vector3 trial = draw_ordered(-200e3, 80e3);
    ASSERT_LT(find_largest_violation(m, return_principal(m, trial)), 1e-4) << trial.transpose();
  }
}

TEST_F(RandomReturns, AnAssociatedReturnIsTheClosestAdmissibleStressInTheEnergyNorm) {
  for (int i = 0; i < 5000; ++i) {
    const Material m = draw_soil(true);
    const Vector3 trial = draw_ordered(-200e3, 80e3), sigma = return_principal(m, trial);
    const Vector3 plastic = principal_stiffness(m).inverse() * (trial - sigma);
    for (int j = 0; j < 20; ++j) {
      const Vector3 other = draw_ordered(-200e3, 40e3);
      if (find_largest_violation(m, other) > 0) continue;
      ASSERT_LT(plastic.dot(other - sigma), 1e-6) << trial.transpose();  // the principle of maximum plastic work
    }
  }
}

}  // namespace
}  // namespace talus::reference
