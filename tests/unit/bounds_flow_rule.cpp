// SPDX-License-Identifier: MIT
// Flow rule and dissipation of soil with weak planes, against a scan of all rates of slip.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bounds/flow_rule.hpp"

namespace talus::bounds {
namespace {

/// Returns the strain rate that slip and opening of the planes leave.
Strain move(const Strain& strain, const WeakPlanes& planes, double slip, double opening) {
  const double c = std::cos(2 * planes.angle), s = std::sin(2 * planes.angle);
  return {strain.opening - opening, strain.difference + slip * s + opening * c,
          strain.distortion - slip * c + opening * s};
}

/// Each division of a strain rate between soil and planes is an upper bound: the least of a scan is not below the
/// result, and near it.
TEST(BoundsFlowRule, DissipatesTheLeastOfAllMotionsOnPlanes) {
  constexpr double step = 0.01;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1), angle(-1.5, 1.5), part(0.1, 1);
  int finite = 0;
  for (int k = 0; k < 120; ++k) {
    const bool is_clay = k % 4 == 0;
    Strength own{1000, is_clay ? 0 : std::tan(0.5), {}};
    if (!is_clay && k % 3 == 0) own.tension = 200;
    const WeakPlanes planes{angle(random), 1000 * part(random), is_clay ? 0 : std::tan(0.5 * part(random))};
    const Strain strain{is_clay ? 0 : 0.6 * part(random), any(random), any(random)};
    const double factor = 0.7 + part(random), tangent = planes.tan_friction / factor;
    Strength soil = own;
    soil.planes = std::make_shared<const WeakPlanes>(planes);
    double least = std::numeric_limits<double>::infinity(), lack = least;
    for (double slip = -2; slip <= 2; slip += step)
      for (double more = 0; more <= (is_clay ? 0 : 0.6); more += step) {
        const double opening = std::abs(slip) * tangent + more;
        const Strain rest = move(strain, planes, slip, opening);
        const double cost =
            is_clay ? std::abs(slip) * planes.cohesion / factor : planes.cohesion / factor * opening / tangent;
        lack = std::min(lack, find_lack(own, factor, rest));
        least = std::min(least, cost + find_dissipation(own, factor, rest));
      }
    const double found = find_dissipation(soil, factor, strain), found_lack = find_lack(soil, factor, strain);
    EXPECT_LE(found_lack, lack + 1e-12) << k;
    EXPECT_GE(found_lack, lack - step) << k;
    if (std::isfinite(least)) {
      ++finite;
      EXPECT_LE(found, least * (1 + 1e-9)) << k;
      EXPECT_GE(found, least - 4000 * step) << k;
    } else if (found_lack > 0) {
      EXPECT_TRUE(std::isinf(found)) << k;
    }
  }
  EXPECT_GT(finite, 40);
}

TEST(BoundsFlowRule, PlanesLimitTheFactorOfAStress) {
  Strength soil{1e6, 0, {}};
  soil.planes = std::make_shared<const WeakPlanes>(WeakPlanes{0.4, 500, std::tan(0.3)});
  const Stress stress{-3000, -9000, 800};
  const double nx = -std::sin(0.4), ny = std::cos(0.4), tx = std::cos(0.4), ty = std::sin(0.4);
  const double px = stress[0] * nx + stress[2] * ny, py = stress[2] * nx + stress[1] * ny;
  const double normal = px * nx + py * ny, shear = px * tx + py * ty;
  EXPECT_NEAR(find_factor(soil, stress), (500 - normal * std::tan(0.3)) / std::abs(shear), 1e-12);
  EXPECT_EQ(find_factor(soil, {5000, 5000, 0}), 0);
}

}  // namespace
}  // namespace talus::bounds
