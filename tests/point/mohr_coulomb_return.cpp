// SPDX-License-Identifier: MIT
// The closed-form return mapping against the plain one that tries every set of planes, and general properties of a
// return.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/draw.hpp"
#include "support/soil_point.hpp"

namespace talus {
namespace {

using reference::Tensor;
using support::Draw;
using support::drive;
using support::Outcome;
using support::Soil;
using support::Voigt;

/// Soils of every kind: φ = 0, c = 0, ψ = 0, ψ = φ, with a cut-off at any height or none.
Soil draw_soil(Draw& draw, bool cut_off) {
  Soil s;
  s.young_modulus = draw(5e6, 50e6);
  s.poisson_ratio = draw(0.0, 0.45);
  s.cohesion = draw(0, 1) < 0.15 ? 0 : draw(1e3, 30e3);
  s.friction = draw(0, 1) < 0.15 ? 0 : draw(0.05, 0.75);
  const double which = draw(0, 1);
  s.dilatancy = which < 0.3 ? 0 : which < 0.5 ? s.friction : draw(0, s.friction);
  if (s.friction == 0 && s.cohesion == 0) s.cohesion = 5e3;
  // without friction nothing but the cut-off limits tension
  if (cut_off) s.tensile_strength = draw(0, 1) * (s.friction > 0 ? s.cohesion / std::tan(s.friction) : 2 * s.cohesion);
  return s;
}

template <int NS>
Voigt<NS> draw_voigt(Draw& draw, double size) {
  Voigt<NS> v;
  for (double& x : v) x = draw(-size, size);
  return v;
}

/// A random stress and increment that lead to trial stresses in and around the whole surface.
template <int NS>
void draw_trial(Draw& draw, const Soil& soil, Voigt<NS>& stress, Voigt<NS>& d) {
  const double size = draw(5e3, 60e3);
  stress = draw_voigt<NS>(draw, 0.3 * size);
  d = draw_voigt<NS>(draw, size / soil.young_modulus);
  const double mean = draw(-2, 1) * size;
  for (std::size_t i = 0; i < 3; ++i) stress[i] += mean;
  if constexpr (NS == 4) d[2] = 0;
  if (draw(0, 1) < 0.2) {  // axisymmetric, and on the axes: two equal principal stresses
    for (std::size_t i = 3; i < NS; ++i) stress[i] = d[i] = 0;
    stress[2] = stress[0], d[2] = d[0];
  }
}

template <int NS>
void expect_the_plain_return(bool cut_off, unsigned seed, int count) {
  Draw draw(seed);
  int yielded = 0;
  double worst = 0;
  for (int n = 0; n < count; ++n) {
    const Soil soil = draw_soil(draw, cut_off);
    Voigt<NS> stress, d;
    draw_trial<NS>(draw, soil, stress, d);
    const auto plain =
        reference::update_stress(soil.plain(), support::to_tensor<NS>(stress), support::to_tensor<NS>(d, true));
    const auto fast = drive<NS>(soil.law(), stress, d);
    const double scale = plain.sigma.norm() + support::to_tensor<NS>(stress).norm() + soil.cohesion +
                         soil.young_modulus * support::to_tensor<NS>(d, true).norm();
    const double error = (support::to_tensor<NS>(fast.stress) - plain.sigma).norm() / scale;
    worst = std::max(worst, error);
    ASSERT_LT(error, 1e-9) << "number " << n << ": E " << soil.young_modulus << " nu " << soil.poisson_ratio << " c "
                           << soil.cohesion << " phi " << soil.friction << " psi " << soil.dilatancy << " t "
                           << soil.tensile_strength << "\nplain\n"
                           << plain.sigma << "\nfast\n"
                           << support::to_tensor<NS>(fast.stress);
    ASSERT_NEAR(fast.plastic_strain, plain.plastic_strain, 1e-9 * (1 + scale / soil.young_modulus)) << n;
    const double dilation = plain.plastic.diagonal().template head<(NS == 4 ? 2 : 3)>().sum();
    ASSERT_NEAR(fast.plastic_dilation, dilation, 1e-9 * scale / soil.young_modulus) << n;
    yielded += fast.yielded;
  }
  EXPECT_GT(yielded, count / 4);
  EXPECT_LT(yielded, count * 99 / 100);
  ::testing::Test::RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST(MohrCoulombReturn, PlaneStrainIsThePlainReturn) {
  expect_the_plain_return<4>(false, 1, 6000);
}
TEST(MohrCoulombReturn, PlaneStrainWithCutOffIsThePlainReturn) {
  expect_the_plain_return<4>(true, 2, 6000);
}
TEST(MohrCoulombReturn, SpaceIsThePlainReturn) {
  expect_the_plain_return<6>(false, 3, 6000);
}
TEST(MohrCoulombReturn, SpaceWithCutOffIsThePlainReturn) {
  expect_the_plain_return<6>(true, 4, 6000);
}

template <int NS>
void expect_physics(unsigned seed) {
  Draw draw(seed);
  for (int n = 0; n < 4000; ++n) {
    const Soil soil = draw_soil(draw, draw(0, 1) < 0.5);
    const auto law = soil.law();
    Voigt<NS> stress, d;
    draw_trial<NS>(draw, soil, stress, d);
    const auto start = drive<NS>(law, stress, {});  // a state inside the surface
    const auto o = drive<NS>(law, start.stress, d);
    const double scale = support::to_tensor<NS>(start.stress).norm() + soil.cohesion +
                         soil.young_modulus * support::to_tensor<NS>(d, true).norm();

    // On an edge the principal stresses of a tensor are known to the square root of round-off, so the first repetition
    // may still move it a little; it must not creep.
    Voigt<NS> again = o.stress;
    for (int i = 0; i < 20; ++i) again = drive<NS>(law, again, {}).stress;
    for (std::size_t i = 0; i < NS; ++i) {
      ASSERT_NEAR(again[i], o.stress[i], (NS == 4 ? 1e-11 : 2e-8) * scale) << "a returned stress must stay, " << n;
    }

    const Tensor plastic = support::find_plastic_strain<NS>(soil, start.stress, d, o.stress);
    const double work = (support::to_tensor<NS>(o.stress).cwiseProduct(plastic)).sum();
    const double before = (support::to_tensor<NS>(start.stress).cwiseProduct(plastic)).sum();
    const double unit = scale * scale / soil.young_modulus;
    ASSERT_NEAR(o.dissipation, 0.5 * (before + work), 1e-9 * unit) << n;
    ASSERT_GE(work, -1e-9 * unit) << "plastic flow must not give energy, " << n;
    const Tensor deviator = plastic - plastic.trace() / 3 * Tensor::Identity();
    ASSERT_NEAR(o.plastic_strain, std::sqrt(2.0 / 3) * deviator.norm(), 1e-9 * (scale / soil.young_modulus)) << n;

    // No principal stress order, shear or tension limit is violated.
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(support::to_tensor<NS>(o.stress));
    const double s3 = solver.eigenvalues()[0], s1 = solver.eigenvalues()[2], sine = std::sin(soil.friction);
    ASSERT_LE((s1 - s3) + (s1 + s3) * sine - 2 * soil.cohesion * std::cos(soil.friction), 1e-9 * scale) << n;
    ASSERT_LE(s1 - soil.tensile_strength, 1e-9 * scale) << n;
  }
}

TEST(MohrCoulombReturn, PlaneStrainStaysDissipatesAndCountsItsStrain) {
  expect_physics<4>(5);
}
TEST(MohrCoulombReturn, SpaceStaysDissipatesAndCountsItsStrain) {
  expect_physics<6>(6);
}

TEST(MohrCoulombReturn, TurningTheTrialTurnsTheResult) {
  Draw draw(7);
  for (int n = 0; n < 2000; ++n) {
    const Soil soil = draw_soil(draw, n % 2 == 0);
    Voigt<6> stress, d;
    draw_trial<6>(draw, soil, stress, d);
    const Tensor q = Eigen::AngleAxisd(draw(0, 6), Eigen::Vector3d(draw(-1, 1), draw(-1, 1), draw(-1, 1)).normalized())
                         .toRotationMatrix();
    const auto straight = drive<6>(soil.law(), stress, d);
    const auto turned = drive<6>(soil.law(), support::to_voigt<6>(q * support::to_tensor<6>(stress) * q.transpose()),
                                 support::to_voigt<6>(q * support::to_tensor<6>(d, true) * q.transpose(), true));
    const double scale =
        support::to_tensor<6>(stress).norm() + soil.young_modulus * support::to_tensor<6>(d, true).norm();
    const Tensor expected = q * support::to_tensor<6>(straight.stress) * q.transpose();
    ASSERT_LT((support::to_tensor<6>(turned.stress) - expected).norm(), 1e-9 * scale) << n;
    ASSERT_NEAR(turned.dissipation, straight.dissipation, 1e-8 * scale * scale / soil.young_modulus) << n;
  }
}

TEST(MohrCoulombReturn, PlaneAndSpaceAgreeOnPlaneStrain) {
  Draw draw(8);
  for (int n = 0; n < 2000; ++n) {
    const Soil soil = draw_soil(draw, n % 2 == 0);
    Voigt<4> stress, d;
    draw_trial<4>(draw, soil, stress, d);
    const auto plane = drive<4>(soil.law(), stress, d);
    const auto space =
        drive<6>(soil.law(), {stress[0], stress[1], stress[2], stress[3], 0, 0}, {d[0], d[1], d[2], d[3], 0, 0});
    const double scale =
        support::to_tensor<4>(stress).norm() + soil.young_modulus * support::to_tensor<4>(d, true).norm();
    for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(plane.stress[i], space.stress[i], 1e-9 * scale) << n;
    ASSERT_NEAR(plane.plastic_strain, space.plastic_strain, 1e-9 * scale / soil.young_modulus) << n;
  }
}

/// Lane by lane the pack gives the double's result; inactive lanes do not matter.
template <int NS>
void expect_lanes_to_agree(unsigned seed) {
  Draw draw(seed);
  for (int n = 0; n < 1500; ++n) {
    const Soil soil = draw_soil(draw, n % 2 == 0);
    const auto law = soil.law();
    Voigt<NS> stress[lane_width], d[lane_width];
    Pack sigma[NS], d_epsilon[NS], state(0.25);
    for (int l = 0; l < lane_width; ++l) {
      draw_trial<NS>(draw, soil, stress[l], d[l]);
      for (std::size_t i = 0; i < NS; ++i) {
        sigma[i].value[l] = stress[l][i];
        d_epsilon[i].value[l] = d[l][i];
      }
    }
    const int idle = n % lane_width;
    Mask active(true);
    set_lane(active, idle, false);
    for (Pack& s : sigma) s.value[idle] = std::nan("");
    const auto response = law.template update<NS>(sigma, d_epsilon, &state, active);
    bool any_yields = false;
    for (int l = 0; l < lane_width; ++l) {
      if (l == idle) {
        EXPECT_EQ(state[l], 0.25) << "an idle lane must not harden";
        continue;
      }
      const Outcome<NS> one = drive<NS>(law, stress[l], d[l]);
      const double scale =
          support::to_tensor<NS>(stress[l]).norm() + soil.young_modulus * support::to_tensor<NS>(d[l], true).norm();
      // A double leaves the neighbouring branches out, a pack selects; both round alike but for the compiler's
      // contraction.
      for (std::size_t i = 0; i < NS; ++i) ASSERT_NEAR(sigma[i][l], one.stress[i], 1e-12 * scale) << n;
      ASSERT_NEAR(state[l] - 0.25, one.plastic_strain, 1e-14 + 1e-12 * scale / soil.young_modulus) << n;
      ASSERT_NEAR(response.dissipation[l], one.dissipation, 1e-11 * scale * scale / soil.young_modulus) << n;
      ASSERT_NEAR(response.plastic_dilation[l], one.plastic_dilation, 1e-14 + 1e-11 * scale / soil.young_modulus) << n;
      any_yields = any_yields || one.yielded;
    }
    EXPECT_EQ(response.any_plastic, any_yields) << n;
  }
}

TEST(MohrCoulombReturn, PackEqualsDoubleInPlaneStrain) {
  expect_lanes_to_agree<4>(9);
}
TEST(MohrCoulombReturn, PackEqualsDoubleInSpace) {
  expect_lanes_to_agree<6>(10);
}

}  // namespace
}  // namespace talus
