// SPDX-License-Identifier: MIT
// Closed-form principal stresses against an eigenvalue solver, and elasticity against Hooke's law in components.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "material/principal_stress.hpp"
#include "support/draw.hpp"
#include "support/soil_point.hpp"

namespace talus {
namespace {

using reference::Tensor;
using support::Draw;
using support::Voigt;

Tensor draw_rotation(Draw& draw) {
  return Eigen::AngleAxisd(draw(0, 6), Eigen::Vector3d(draw(-1, 1), draw(-1, 1), draw(-1, 1)).normalized())
      .toRotationMatrix();
}

TEST(PrincipalStress, PolynomialIsTheCosineOfAThirdOfTheAngle) {
  const material::CosineThird cosine;
  double worst = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double u = i / 20000.0;
    worst = std::max(
        worst, std::abs(cosine(u) - static_cast<double>(std::cos(2 / 3.0L * std::acos(static_cast<long double>(u))))));
  }
  EXPECT_LT(worst, 3e-13);
}

TEST(PrincipalStress, SpaceAgreesWithAnEigenvalueSolver) {
  Draw draw(1);
  const material::CosineThird cosine;
  for (int n = 0; n < 5000; ++n) {
    const double size = std::pow(10.0, draw(2, 6));
    Voigt<6> v;
    for (double& x : v) x = draw(-size, size);
    const material::SpacePrincipal<double> s(v.data(), cosine);
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(support::to_tensor<6>(v));
    // J3/q³ loses half the digits where two principal values come near; away from there round-off remains
    const double tolerance =
        1e-12 * (s.q + std::abs(s.p)) + 1e-8 * s.q * (std::min(s.d1 - s.d2, s.d2 - s.d3) < 1e-2 * s.q);
    ASSERT_NEAR(s.s1, solver.eigenvalues()[2], tolerance) << n;
    ASSERT_NEAR(s.s2, solver.eigenvalues()[1], tolerance) << n;
    ASSERT_NEAR(s.s3, solver.eigenvalues()[0], tolerance) << n;
  }
}

TEST(PrincipalStress, EqualPrincipalStressesComeOutEqual) {
  Draw draw(2);
  const material::CosineThird cosine;
  for (int n = 0; n < 1000; ++n) {
    const double a = draw(-1e5, 1e5), b = draw(-1e5, 1e5);
    const Tensor q = n % 4 == 0 ? Tensor(Tensor::Identity()) : draw_rotation(draw);
    const Tensor t = q * Eigen::Vector3d(a, a, b).asDiagonal() * q.transpose();
    const material::SpacePrincipal<double> s(support::to_voigt<6>(t).data(), cosine);
    const double high = std::max(a, b), low = std::min(a, b);
    // A double root of the cubic is known to the square root of round-off only.
    const double tolerance = 1e-7 * (std::abs(a) + std::abs(b));
    EXPECT_NEAR(s.s1, high, tolerance) << n;
    EXPECT_NEAR(s.s3, low, tolerance) << n;
    EXPECT_NEAR(s.s2, a, tolerance) << n;
  }
  const Voigt<6> isotropic{-7e4, -7e4, -7e4, 0, 0, 0};
  const material::SpacePrincipal<double> s(isotropic.data(), cosine);
  EXPECT_DOUBLE_EQ(s.s1, -7e4);
  EXPECT_DOUBLE_EQ(s.s2, -7e4);
  EXPECT_DOUBLE_EQ(s.s3, -7e4);
  const Voigt<6> none{};
  const material::SpacePrincipal<double> zero(none.data(), cosine);
  EXPECT_EQ(zero.s1, 0);
  EXPECT_EQ(zero.s3, 0);
}

TEST(PrincipalStress, ComposingTheSameValuesGivesTheStressBack) {
  Draw draw(3);
  const material::CosineThird cosine;
  for (int n = 0; n < 4000; ++n) {
    // also pairs of principal values that come closer and closer: below √round-off of each other they count as equal
    const double gap = std::pow(10.0, draw(-16, 0));
    const Tensor q = draw_rotation(draw);
    const double a = draw(-1e5, 1e5), b = a + gap * 1e5, c = draw(-1e5, 1e5);
    const Tensor t = q * Eigen::Vector3d(a, b, c).asDiagonal() * q.transpose();
    const Voigt<6> v = support::to_voigt<6>(t);
    const material::SpacePrincipal<double> s(v.data(), cosine);
    Voigt<6> r{};
    s.compose(s.s1, s.s2, s.s3, r.data());
    for (std::size_t i = 0; i < 6; ++i) ASSERT_NEAR(r[i], v[i], 3e-8 * 2e5) << n << " gap " << gap;

    Voigt<4> plane{v[0], v[1], v[2], v[3]};
    const material::PlanePrincipal<double> p(plane.data());
    Voigt<4> back{};
    for (std::size_t i = 0; i < 4; ++i) back[i] = plane[i];
    p.compose(p.s1, p.s2, p.s3, back.data());
    for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(back[i], plane[i], 1e-15 * 4e5) << n;
  }
}

TEST(PrincipalStress, PlaneStrainOrdersTheOutOfPlaneStress) {
  for (double z : {-3e4, -1.5e4, -5e3, 1e4}) {
    const Voigt<4> v{-1e4, -2e4, z, 4e3};
    const material::PlanePrincipal<double> p(v.data());
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(support::to_tensor<4>(v));
    EXPECT_NEAR(p.s1, solver.eigenvalues()[2], 1e-10);
    EXPECT_NEAR(p.s2, solver.eigenvalues()[1], 1e-10);
    EXPECT_NEAR(p.s3, solver.eigenvalues()[0], 1e-10);
  }
}

TEST(LinearElastic, FollowsHookesLawAndItsEnergy) {
  const double e = 30e6, nu = 0.28;
  const auto law = material::LinearElastic::from_young(e, nu);
  Draw draw(4);
  for (int n = 0; n < 200; ++n) {
    Voigt<6> d, s{};
    for (double& x : d) x = draw(-1e-3, 1e-3);
    law.add_elastic_increment<6>(s.data(), d.data());
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(d[i], (s[i] - nu * (s[(i + 1) % 3] + s[(i + 2) % 3])) / e, 1e-15);
      EXPECT_NEAR(d[3 + i], s[3 + i] * 2 * (1 + nu) / e, 1e-15);
    }
    double energy = 0;
    for (std::size_t i = 0; i < 6; ++i) energy += 0.5 * s[i] * d[i];
    EXPECT_NEAR(law.elastic_energy<6>(s.data()), energy, 1e-13 * e * 1e-6);
  }
  EXPECT_NEAR(law.constrained_modulus(), e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), 1e-6);
}

}  // namespace
}  // namespace talus
