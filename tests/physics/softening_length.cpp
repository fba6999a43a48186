// SPDX-License-Identifier: MIT
// Nonlocal softening: residual load of a block of clay after its peak, on four meshes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mpm/solver/step.hpp"
#include "support/clay_block.hpp"

namespace talus {
namespace {

/// Mean of σ_x - σ_y [Pa].
double find_deviatoric(const mpm::Body<2>& body) {
  double sum = 0, volume = 0;
  support::for_each_point<2>(body, [&](int, const auto& p) {
    sum += (p.stress[0] - p.stress[1]) * p.volume;
    volume += p.volume;
  });
  return sum / volume;
}

struct Curve {
  double peak = 0, end = 0;  ///< mean deviatoric stress [Pa]
};

/// To a strain of 10 %.
Curve press(int cells, double length) {
  mpm::Body<2> body = support::make_clay_block<2>(cells, length);
  mpm::StepOptions<2> o = support::make_block_options(body);
  Curve curve;
  for (double time = 0; time < 0.10 / support::squeezing;) {
    o.dt = 0.7 * mpm::find_critical_step(body, 1).dt;
    support::run_steps(body, o, 50);
    time += 50 * o.dt;
    curve.end = find_deviatoric(body);
    curve.peak = std::max(curve.peak, curve.end);
  }
  std::printf("%d squares, length %g m: peak %.1f kPa, end %.1f kPa\n", cells, length, curve.peak / 1e3,
              curve.end / 1e3);
  return curve;
}

/// All four meshes of theory 23.
TEST(SofteningLength, DISABLED_OfFourMeshes) {
  for (const double length : {0.0, 0.15, 0.3})
    for (const int cells : {8, 12, 16, 24}) press(cells, length);
}

TEST(SofteningLength, WhatABlockKeepsDoesNotDependOnTheMesh) {
  const Curve coarse = press(8, 0.3), fine = press(12, 0.3);
  EXPECT_NEAR(coarse.end, fine.end, 0.02 * fine.end);
  EXPECT_LT(fine.end, 0.95 * fine.peak) << "it must soften to test anything";
  const Curve own_coarse = press(8, 0), own_fine = press(12, 0);
  EXPECT_GT(own_coarse.end - own_fine.end, 1.5 * std::abs(coarse.end - fine.end));
}

}  // namespace
}  // namespace talus
