// SPDX-License-Identifier: MIT
// Drained triaxial compression of the loess of the source (Table 4.1, Figure 4.3) against an independently computed
// table, and the critical states in closed form.

#include <gtest/gtest.h>

#include "support/clay_point.hpp"

namespace {

using namespace talus;
using support::kpa;

material::CamClayParameters make_loess() {
  return {.compression = 0.089, .swelling = 0.022, .poisson_ratio = 0.3, .critical_state_slope = 1.42};
}

/// q at axial strains of 5, 10, 15, 20, 25 % [kPa], and the volumetric strain at 20 % [%].
struct Row {
  double radial, content;
  std::array<double, 5> q;
  double volume;
};

class Figure43 : public testing::TestWithParam<Row> {};

TEST_P(Figure43, AgreesWithTheTable) {
  const Row row = GetParam();
  const material::RootedCamClay law(make_loess(), {.hardening = 0.28, .strength = 0.18});
  auto point = support::start_isotropic<6>(law, row.radial * kpa, 0.86, 125 * kpa, row.content);
  double volume = 0;
  for (int i = 1; i <= 2500; ++i) {
    volume += support::step_triaxial(law, point, 1e-4, row.radial * kpa);
    if (i % 500 == 0) {
      const double expected = row.q[static_cast<std::size_t>(i / 500 - 1)] * kpa;
      EXPECT_NEAR(point.q(), expected, 0.005 * expected) << i / 100 << " %";
      if (i == 2000) {
        EXPECT_NEAR(100 * volume, row.volume, 0.005 * row.volume);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CamClay, Figure43,
                         testing::Values(Row{100, 0, {165.1, 226.2, 252.7, 263.2, 267.2}, 4.77},
                                         Row{100, 0.44, {186.3, 253.4, 282.6, 294.1, 298.5}, 4.50},
                                         Row{100, 0.88, {210.5, 283.7, 315.9, 328.6, 333.5}, 4.25},
                                         Row{200, 0, {312.1, 443.4, 501.4, 524.7, 533.7}, 5.61},
                                         Row{200, 0.88, {363.9, 538.0, 618.5, 651.7, 664.6}, 5.99},
                                         Row{300, 0, {468.1, 665.2, 752.0, 787.1, 800.6}, 5.61},
                                         Row{300, 0.88, {545.9, 807.0, 927.8, 977.6, 996.9}, 5.99}));

}  // namespace
