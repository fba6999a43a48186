// SPDX-License-Identifier: MIT
// Cam-clay for any state and increment: finite numbers, admissible stresses, no creation of energy.

#include <gtest/gtest.h>

#include "support/clay_draw.hpp"

namespace {

using namespace talus;

/// Checks the invariants of the state after a step.
template <int NS>
void expect_admissible(const material::RootedCamClay& law, const support::ClayPoint<NS, true>& point,
                       double plastic_before) {
  for (const double s : point.stress) ASSERT_TRUE(std::isfinite(s));
  for (const double s : point.state) ASSERT_TRUE(std::isfinite(s));
  const double p_c = law.find_preconsolidation(point.state.data(), point.saturation);
  const double p = point.p(), q = point.q(), m = support::find_slope(law, point.state.data());
  EXPECT_LE(q * q / (m * m) - p * (p_c - p), 1e-8 * p_c * p_c)
      << "p " << p << " q " << q << " p_c " << p_c << " M " << m;
  if (point.dissipation > 0) {  // p'_c itself, before its floor
    const double exponent = law.soil().suction_hardening * (1 - point.saturation) + point.state[6] * point.state[4];
    EXPECT_GE(point.state[1] * std::exp(exponent), 0.999e-3 * law.soil().smallest_pressure);
  }
  EXPECT_GE(point.dissipation, -1e-9 * p_c);
  EXPECT_GE(point.state[0], plastic_before);
  EXPECT_GE(point.state[2], 0.01);
  EXPECT_LE(point.state[2], 4.0);
}

/// Five steps of a size between 1e-8 and 0.1 from each of `count` points, with jumps of saturation.
template <int NS>
void sweep(int count, unsigned seed) {
  support::Draw draw(seed);
  for (int i = 0; i < count; ++i) {
    const auto law = support::draw_soil(draw);
    auto point = support::draw_clay_point<NS>(draw, law);
    for (int k = 0; k < 5; ++k) {
      const double before = point.state[0];
      point.saturation = draw(0.3, 1);
      const auto d = support::draw_increment<NS>(draw, support::draw_logarithmic(draw, 1e-8, 0.1));
      const auto old = point;
      point.step(law, d);
      expect_admissible<NS>(law, point, before);
      if (testing::Test::HasFailure()) {
        FAIL() << "soil " << i << ", step " << k << ": from p " << old.p() << " q " << old.q() << " p_b "
               << old.state[1] << " e " << old.state[2];
      }
    }
  }
}

TEST(CamClayRobustness, PlaneStrain) {
  sweep<4>(100000, 1);
}
TEST(CamClayRobustness, ThreeDimensions) {
  sweep<6>(20000, 2);
}

}  // namespace
