// SPDX-License-Identifier: MIT
// Rooted Mohr–Coulomb against Mohr–Coulomb with the sum of both cohesions, on planes, edges, apex and tension cut-off,
// with reduced strength, for one point and for packs of different points.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "material/rooted_mohr_coulomb.hpp"
#include "support/draw.hpp"

namespace talus {
namespace {

using material::LinearElastic;
using material::MohrCoulomb;
using material::MohrCoulombStrength;
using material::RootedMohrCoulomb;
using support::Draw;

constexpr double young_modulus = 20e6;

/// A soil of any kind: no cohesion but the roots', no friction, no or full dilatancy, a cut-off anywhere or none.
struct Soil {
  LinearElastic elastic;
  MohrCoulombStrength strength;
  double factor = 1;
};

Soil draw_soil(Draw& draw) {
  Soil s;
  s.elastic = LinearElastic::from_young(young_modulus, draw(0, 0.45));
  const bool frictionless = draw(0, 1) < 0.15;
  s.strength.cohesion = draw(0, 1) < 0.2 ? 0 : draw(1e3, 30e3);
  s.strength.friction_angle = frictionless ? 0 : draw(0.05, 0.75);
  const double which = draw(0, 1);
  s.strength.dilatancy_angle = s.strength.friction_angle * (which < 0.3 ? 0.0 : which < 0.5 ? 1.0 : draw(0, 1));
  // Below, at and above the apex of the bare soil, so that the roots move the limit in some of them.
  const double apex = frictionless ? 20e3 : (s.strength.cohesion + 15e3) / std::tan(s.strength.friction_angle);
  s.strength.tensile_strength = draw(0, 1) < 0.3 ? 1e9 : draw(0, 1.5) * apex;
  s.factor = draw(0, 1) < 0.5 ? 1 : draw(0.7, 2);
  return s;
}

RootedMohrCoulomb make_rooted(const Soil& s) {
  return {s.elastic, s.strength.reduced(s.factor), s.factor};
}

MohrCoulomb make_sum(const Soil& s, double root_cohesion) {
  MohrCoulombStrength sum = s.strength;
  sum.cohesion += root_cohesion;
  return {s.elastic, sum.reduced(s.factor)};
}

template <int NS>
std::array<double, NS> draw_voigt(Draw& draw, double size) {
  std::array<double, NS> v;
  for (double& x : v) x = draw(-size, size);
  return v;
}

template <int NS>
void draw_trial(Draw& draw, std::array<double, NS>& stress, std::array<double, NS>& d) {
  const double size = draw(5e3, 80e3);
  stress = draw_voigt<NS>(draw, 0.3 * size);
  d = draw_voigt<NS>(draw, size / young_modulus);
  const double mean = draw(-2, 1) * size;
  for (std::size_t i = 0; i < 3; ++i) stress[i] += mean;
  if constexpr (NS == 4) d[2] = 0;
}

/// Round-off of sums of stresses of this size; the two laws add the two cohesions at different places.
template <int NS>
double find_round_off(const std::array<double, NS>& stress, const std::array<double, NS>& d) {
  double scale = 100e3;
  for (const double s : stress) scale = std::max(scale, std::abs(s));
  for (const double e : d) scale = std::max(scale, 2 * young_modulus * std::abs(e));
  return 1e-11 * scale;
}

/// Increments per soil: a law's tables cost far more than its update.
constexpr int trials = 200;

template <int NS>
void expect_the_sum(unsigned seed, int soils) {
  Draw draw(seed);
  int yielded = 0, torn = 0;
  for (int n = 0; n < soils; ++n) {
    const Soil soil = draw_soil(draw);
    const double root_cohesion = n % 10 == 0 && soil.strength.cohesion > 0 ? 0 : draw(100, 30e3);
    const RootedMohrCoulomb rooted_law = make_rooted(soil);
    const MohrCoulomb sum_law = make_sum(soil, root_cohesion);
    for (int t = 0; t < trials; ++t) {
      std::array<double, NS> rooted, d;
      draw_trial<NS>(draw, rooted, d);
      std::array<double, NS> sum = rooted;
      const double round_off = find_round_off<NS>(rooted, d);
      double rooted_state[] = {0.01, root_cohesion}, sum_state[] = {0.01};
      const auto a = rooted_law.update<NS>(rooted.data(), d.data(), rooted_state, true);
      const auto b = sum_law.update<NS>(sum.data(), d.data(), sum_state, true);
      for (std::size_t i = 0; i < NS; ++i)
        ASSERT_NEAR(rooted[i], sum[i], round_off) << "component " << i << " of " << n;
      ASSERT_NEAR(rooted_state[0], sum_state[0], 10 * round_off / young_modulus) << n;
      ASSERT_EQ(rooted_state[1], root_cohesion);
      ASSERT_NEAR(a.plastic_dilation, b.plastic_dilation, 10 * round_off / young_modulus) << n;
      ASSERT_NEAR(a.dissipation, b.dissipation, 0.1 * round_off) << n;
      yielded += sum_state[0] > 0.01 ? 1 : 0;
      torn += sum_state[0] > 0.01 && soil.strength.tensile_strength < 1e8 && b.plastic_dilation > 0 ? 1 : 0;
    }
  }
  // The draw must reach what it is to test.
  EXPECT_GT(yielded, soils * trials / 4);
  EXPECT_GT(torn, soils * trials / 20);
}

TEST(RootedMohrCoulomb, IsMohrCoulombWithTheSumOfCohesionsInPlaneStrain) {
  expect_the_sum<4>(1, 200);
}

TEST(RootedMohrCoulomb, IsMohrCoulombWithTheSumOfCohesionsInSpace) {
  expect_the_sum<6>(2, 200);
}

/// Lanes of one law with different root cohesions, each against its own sum.
template <int NS>
void expect_the_sum_in_each_lane(unsigned seed, int soils) {
  Draw draw(seed);
  for (int n = 0; n < soils; ++n) {
    const Soil soil = draw_soil(draw);
    const RootedMohrCoulomb rooted_law = make_rooted(soil);
    std::vector<MohrCoulomb> sum_laws;
    Pack cohesion(0.0);
    for (int l = 0; l < lane_width; ++l) {
      cohesion.value[l] = draw(100, 30e3);
      sum_laws.push_back(make_sum(soil, cohesion[l]));
    }
    for (int t = 0; t < trials; ++t) {
      Pack sigma[NS], d[NS], state[2] = {Pack(0.0), cohesion};
      std::array<std::array<double, NS>, lane_width> stress, strain;
      for (int l = 0; l < lane_width; ++l) {
        const auto at = static_cast<std::size_t>(l);
        draw_trial<NS>(draw, stress[at], strain[at]);
        for (std::size_t i = 0; i < NS; ++i) {
          sigma[i].value[l] = stress[at][i];
          d[i].value[l] = strain[at][i];
        }
      }
      const auto r = rooted_law.update<NS>(sigma, d, state, Mask(true));
      for (int l = 0; l < lane_width; ++l) {
        const auto at = static_cast<std::size_t>(l);
        const double round_off = find_round_off<NS>(stress[at], strain[at]);
        double sum_state = 0;
        const auto b = sum_laws[at].update<NS>(stress[at].data(), strain[at].data(), &sum_state, true);
        for (std::size_t i = 0; i < NS; ++i) ASSERT_NEAR(sigma[i][l], stress[at][i], round_off) << "lane " << l;
        ASSERT_NEAR(state[0][l], sum_state, 10 * round_off / young_modulus);
        ASSERT_NEAR(r.plastic_dilation[l], b.plastic_dilation, 10 * round_off / young_modulus);
      }
    }
  }
}

TEST(RootedMohrCoulomb, GivesEachPointOfAPackItsOwnCohesion) {
  expect_the_sum_in_each_lane<4>(3, 60);
  expect_the_sum_in_each_lane<6>(4, 60);
}

TEST(RootedMohrCoulomb, LetsRootsBearTensionOnlyUpToTheGivenTensileStrength) {
  const double c = 2e3, phi = std::atan(0.5);
  const auto elastic = LinearElastic::from_young(young_modulus, 0.3);
  // Pulled far apart in all directions: what is left is the limit of tension.
  const auto pull = [&](double tensile_strength, double root_cohesion) {
    double sigma[4] = {0, 0, 0, 0}, state[] = {0, root_cohesion};
    const double d[4] = {0.1, 0.1, 0.1, 0};
    RootedMohrCoulomb(elastic, {c, phi, 0, tensile_strength}).update<4>(sigma, d, state, true);
    return sigma[0];
  };
  EXPECT_NEAR(pull(1e9, 0), 4e3, 1e-3);     // the apex c/tanφ
  EXPECT_NEAR(pull(1e9, 3e3), 10e3, 1e-3);  // (c + c_r)/tanφ
  EXPECT_NEAR(pull(7e3, 0), 4e3, 1e-3);
  EXPECT_NEAR(pull(7e3, 3e3), 7e3, 1e-3);
  EXPECT_NEAR(pull(0, 3e3), 0, 1e-3);
}

}  // namespace
}  // namespace talus
