// SPDX-License-Identifier: MIT
// Cam-clay against independent plain integrations: small explicit steps along random paths, nested bisection for single
// large steps, and the order of convergence with the step.

#include <gtest/gtest.h>

#include "reference/plain_cam_clay.hpp"
#include "support/clay_draw.hpp"

namespace {

using namespace talus;
using reference::PlainClay;
using reference::PlainClayState;
using reference::Tensor3;

PlainClay make_plain(const material::RootedCamClay& law, double content) {
  const auto& s = law.soil();
  const auto& r = law.roots();
  return {s.compression, s.swelling, s.poisson_ratio, s.critical_state_slope, s.suction_hardening, s.smallest_pressure,
          r.hardening,   r.strength, content,         r.breaking_strain,      r.breaking_range,    r.residual_share};
}

/// Tensor of compression positive from a vector of tension positive; shear strains are engineering strains.
template <int NS>
Tensor3 to_compression(const std::array<double, NS>& v, bool strain) {
  const double half = strain ? -0.5 : -1;
  Tensor3 t = Tensor3::Zero();
  for (int i = 0; i < 3; ++i) t(i, i) = -v[static_cast<std::size_t>(i)];
  t(0, 1) = t(1, 0) = half * v[3];
  if constexpr (NS == 6) {
    t(1, 2) = t(2, 1) = half * v[4];
    t(2, 0) = t(0, 2) = half * v[5];
  }
  return t;
}

template <int NS>
PlainClayState make_plain_state(const support::ClayPoint<NS, true>& point) {
  const auto& s = point.state;
  return {to_compression<NS>(point.stress, false), s[1], s[2], s[4], s[5], s[6], point.saturation};
}

template <int NS>
double find_distance(const support::ClayPoint<NS, true>& point, const PlainClayState& plain) {
  return (to_compression<NS>(point.stress, false) - plain.stress).norm();
}

/// A soil like the source's, with a ratio of overconsolidation from 1 to 20.
template <int NS>
support::ClayPoint<NS, true> draw_path_start(support::Draw& draw, const material::RootedCamClay& law) {
  const double p = support::draw_logarithmic(draw, 5e3, 5e5);
  auto point = support::start_isotropic<NS>(law, p, draw(0.4, 1.5), p * support::draw_logarithmic(draw, 1, 10),
                                            draw(0, 2), draw(0.6, 1));
  return point;
}
material::RootedCamClay draw_path_soil(support::Draw& draw) {
  const double lambda = draw(0.05, 0.2);
  return material::RootedCamClay({.compression = lambda,
                                  .swelling = lambda * draw(0.1, 0.4),
                                  .poisson_ratio = draw(0.1, 0.4),
                                  .critical_state_slope = draw(0.7, 1.5),
                                  .suction_hardening = draw(0, 5)},
                                 {.hardening = draw(0, 0.4),
                                  .strength = draw(0, 0.2),
                                  .breaking_strain = draw(0, 1) < 0.3 ? draw(0.005, 0.02) : 10,
                                  .breaking_range = draw(0.01, 0.03)});
}

/// Three legs of 3 % strain in random directions with wetting or drying, in `steps` steps each.
template <int NS>
void compare_paths(int count, unsigned seed) {
  support::Draw draw(seed);
  int plastic = 0, dry = 0;
  for (int i = 0; i < count; ++i) {
    const auto law = draw_path_soil(draw);
    auto point = draw_path_start<NS>(draw, law);
    const PlainClay clay = make_plain(law, point.state[3]);
    PlainClayState plain = make_plain_state<NS>(point);
    constexpr int steps = 2000, substeps = 10;
    for (int leg = 0; leg < 3; ++leg) {
      const auto whole = support::draw_increment<NS>(draw, 0.03);
      const double drying = draw(-0.05, 0.05) / steps;
      std::array<double, NS> d{};
      for (std::size_t k = 0; k < NS; ++k) d[k] = whole[k] / steps;
      const Tensor3 part = to_compression<NS>(d, true) / substeps;
      for (int k = 0; k < steps; ++k) {
        point.saturation += drying;
        point.step(law, d);
        plastic += point.dissipation > 0;
        dry += point.plastic_dilation > 0;
        for (int j = 0; j < substeps; ++j) {
          plain.saturation += drying / substeps;
          reference::step_explicitly(clay, plain, part);
        }
      }
      const double scale = reference::find_p_c(clay, plain);
      EXPECT_LT(find_distance<NS>(point, plain), 2e-3 * scale) << "path " << i << ", leg " << leg;
      EXPECT_NEAR(law.find_preconsolidation(point.state.data(), point.saturation), scale, 2e-3 * scale) << i;
      EXPECT_NEAR(point.state[2], plain.e, 1e-9);
      EXPECT_NEAR(point.state[5], plain.eps_r, 1e-9);
      EXPECT_NEAR(point.state[6], plain.share, 1e-9);
    }
  }
  EXPECT_GT(plastic, 2000 * count);
  EXPECT_GT(dry, 500 * count);
}

TEST(CamClayReference, FollowsExplicitIntegrationInPlaneStrain) {
  compare_paths<4>(40, 1);
}
TEST(CamClayReference, FollowsExplicitIntegrationInSpace) {
  compare_paths<6>(40, 2);
}

TEST(CamClayReference, LargeStepsSolveTheEquationsOfTheStep) {
  support::Draw draw(3);
  int plastic = 0;
  for (int i = 0; i < 3000; ++i) {
    auto law = support::draw_soil(draw);
    auto soil = law.soil();
    soil.strength_factor = 1;
    soil.swelling = std::min(soil.swelling, 0.3 * soil.compression);
    law = material::RootedCamClay(soil, law.roots());
    auto point = support::draw_clay_point<6>(draw, law);
    const PlainClay clay = make_plain(law, point.state[3]);
    PlainClayState plain = make_plain_state<6>(point);
    const auto d = support::draw_increment<6>(draw, support::draw_logarithmic(draw, 1e-6, 0.03));
    point.step(law, d);
    reference::step_implicitly(clay, plain, to_compression<6>(d, true));
    plastic += point.dissipation > 0;
    const double p_c = reference::find_p_c(clay, plain);
    EXPECT_LT(find_distance<6>(point, plain), 1e-7 * (p_c + plain.stress.norm())) << i;
    EXPECT_NEAR(law.find_preconsolidation(point.state.data(), point.saturation) / p_c, 1, 1e-4) << i;
  }
  EXPECT_GT(plastic, 1000);
}

TEST(CamClayReference, ErrorFallsWithTheStep) {
  const material::RootedCamClay law(
      {.compression = 0.1, .swelling = 0.02, .poisson_ratio = 0.3, .critical_state_slope = 1.2, .suction_hardening = 3},
      {.hardening = 0.3, .strength = 0.1});
  for (const double ratio : {1.0, 8.0}) {
    const auto end = [&](int steps) {
      auto point = support::start_isotropic<4>(law, 50e3, 0.8, 50e3 * ratio, 1.0, 0.9);
      for (int i = 0; i < steps; ++i) {
        point.saturation += 0.05 / steps;
        point.step(law, {0.02 / steps, -0.04 / steps, 0, 0.06 / steps});
      }
      return point;
    };
    const auto fine = end(200000);
    double before = 0;
    for (const int steps : {50, 100, 200, 400}) {
      const auto point = end(steps);
      double error = 0;
      for (std::size_t k = 0; k < 4; ++k) error = std::max(error, std::abs(point.stress[k] - fine.stress[k]));
      if (before > 0) {
        EXPECT_NEAR(before / error, 2, 0.3) << steps;
      }
      before = error;
    }
  }
}

}  // namespace
