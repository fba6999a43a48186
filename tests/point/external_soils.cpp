// SPDX-License-Identifier: MIT
// UMATs in Fortran on strain paths: modified Cam-clay against the built-in model, and the softening clay of the example
// against its law.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "material/cam_clay.hpp"
#include "support/external_model.hpp"

namespace talus {
namespace {

using material::External;
using support::open_umat;

/// Strain at the end of a path (compression negative), and where it starts.
struct Path {
  const char* name;
  double pressure, preconsolidation;  ///< p' and p'_c at the start [Pa]
  std::array<double, 6> strain;
};

constexpr double e_0 = 0.8, lambda = 0.12, kappa = 0.02, nu = 0.3, m = 1.1, smallest = 1e3;

const std::vector<Path> paths = {
    {"isotropic compression", 50e3, 80e3, {-0.02, -0.02, -0.02, 0, 0, 0}},
    {"oedometer", 50e3, 60e3, {-0.08, 0, 0, 0, 0, 0}},
    {"undrained compression, wet side", 100e3, 110e3, {-0.1, 0.05, 0.05, 0, 0, 0}},
    {"undrained extension, dry side", 20e3, 200e3, {0.06, -0.03, -0.03, 0, 0, 0}},
    {"simple shear", 60e3, 90e3, {0, 0, 0, 0.15, 0, 0}},
    {"shear in three planes", 60e3, 90e3, {-0.01, 0, 0.005, 0.06, -0.08, 0.04}},
    {"softening with swelling", 30e3, 250e3, {-0.05, 0.04, 0.02, 0.03, 0, 0}},
    {"unloading", 100e3, 100e3, {0.01, 0.005, 0.005, 0.004, 0, 0}},
};

template <int NS>
void expect_built_in_cam_clay() {
  const material::ModifiedCamClay built_in({.compression = lambda,
                                            .swelling = kappa,
                                            .poisson_ratio = nu,
                                            .critical_state_slope = m,
                                            .smallest_pressure = smallest});
  const External external = open_umat({"cam_clay", {lambda, kappa, nu, m, smallest}, 2});
  double largest = 0;
  for (const Path& path : paths) {
    double s[NS] = {}, x[NS] = {}, d[NS], q[material::ModifiedCamClay::state_size] = {}, y[External::state_size] = {};
    for (int i = 0; i < 3; ++i) s[i] = x[i] = -path.pressure;
    q[1] = y[1] = path.preconsolidation;
    q[2] = y[2] = e_0;
    constexpr int steps = 10000, looks = 20;
    for (int i = 0; i < NS; ++i) d[i] = path.strain[static_cast<std::size_t>(i)] / steps;
    for (int n = 1; n <= steps; ++n) {
      built_in.update<NS>(s, d, q, true);
      external.update<NS>(x, d, y, true);
      external.throw_failure();
      if (n % (steps / looks) != 0) continue;
      const double fraction = static_cast<double>(n) / steps;
      double size = 0;
      for (int i = 0; i < NS; ++i) size = std::max(size, std::abs(s[i]));
      for (int i = 0; i < NS; ++i) {
        ASSERT_NEAR(x[i], s[i], 1e-3 * size) << path.name << ", component " << i << " at " << fraction;
        largest = std::max(largest, std::abs(x[i] - s[i]) / size);
      }
      ASSERT_NEAR(y[1], q[1], 1e-3 * q[1]) << path.name << ", p'c at " << fraction;
      ASSERT_NEAR(y[2], q[2], 1e-3 * q[2]) << path.name << ", e at " << fraction;
      largest = std::max(largest, std::abs(y[1] / q[1] - 1));
    }
    if (path.strain[0] != 0.01) {  // and something happened
      ASSERT_GT(std::abs(q[1] / path.preconsolidation - 1), 0.01) << path.name;
    }
  }
  testing::Test::RecordProperty("largest_difference", std::to_string(largest));
}

TEST(ExternalSoils, CamClayInFortranIsTheBuiltInOne) {
  TALUS_NEEDS_FORTRAN("cam_clay");
  expect_built_in_cam_clay<4>();
  expect_built_in_cam_clay<6>();
}

// Simple shear: elastic to the peak strength, then τ = s_u(g) with g = γ - τ/G.
TEST(ExternalSoils, SofteningClayOfTheExampleFollowsItsLaw) {
  TALUS_NEEDS_FORTRAN("softening_clay");
  const double young = 5e6, poisson = 0.49, peak = 25e3, rest = 8e3, scale = 0.1;
  const double shear = young / (2 * (1 + poisson));
  const External law = open_umat({"softening_clay", {young, poisson, peak, rest, scale}, 2});
  double s[4] = {-50e3, -50e3, -50e3, 0}, q[External::state_size] = {}, work = 0;
  const int steps = 400;
  const double gamma = 0.5 / steps, d[4] = {0, 0, 0, gamma};
  for (int n = 1; n <= steps; ++n) {
    const double before = s[3];
    work += law.update<4>(s, d, q, true).dissipation;
    law.throw_failure();
    const double g = n * gamma - s[3] / shear;
    if (n * gamma < peak / shear) {
      EXPECT_NEAR(s[3], before + shear * gamma, 1e-9 * peak);
      EXPECT_EQ(q[1], 0);
    } else {
      EXPECT_NEAR(s[3], rest + (peak - rest) * std::exp(-g / scale), 1e-9 * peak) << n;
      EXPECT_NEAR(q[1], g, 1e-9);
    }
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(s[i], -50e3, 1e-6) << "no volume changes, so no mean stress either";
  }
  // SPD is the area under τ(g), by the end-point rule of the steps.
  const double g = q[1];
  const double area = rest * g + (peak - rest) * scale * (1 - std::exp(-g / scale));
  EXPECT_NEAR(work, area, 2e-3 * area);
  EXPECT_LT(s[3], 1.1 * rest) << "most of the loss has happened";

  // There is no solution if the strength falls faster than the soil unloads.
  const External brittle = open_umat({"softening_clay", {young, poisson, peak, 0, 1e-4}, 2});
  double t[4] = {0, 0, 0, 0.999 * peak}, p[External::state_size] = {};
  const double step[4] = {0, 0, 0, 0.01 * peak / shear};
  brittle.update<4>(t, step, p, true);
  EXPECT_EQ(t[3], 0.999 * peak);
  const auto failure = brittle.take_failure();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->answer.find("PNEWDT = 0.5"), std::string::npos) << failure->answer;
}

}  // namespace
}  // namespace talus
