// SPDX-License-Identifier: MIT
// The case file of examples/triaxial_loess against an independent integration of the rooted-soil model (4.1–4.15).

#include <array>
#include <string>

#include "input/read.hpp"
#include "laboratory/point_results.hpp"
#include "support/point_soils.hpp"

namespace talus::laboratory {
namespace {

/// q [kPa] at 5, 10, 15, 20 and 25 % of axial strain, and ε_v [%] at 20 %.
struct Published {
  std::string test;
  std::array<double, 5> q;
  double volumetric;
};
const std::array<Published, 7> table{{{"100 kPa, bare", {165.1, 226.2, 252.7, 263.2, 267.2}, 4.77},
                                      {"100 kPa, 0.44 % roots", {186.3, 253.4, 282.6, 294.1, 298.5}, 4.50},
                                      {"100 kPa, 0.88 % roots", {210.5, 283.7, 315.9, 328.6, 333.5}, 4.25},
                                      {"200 kPa, bare", {312.1, 443.4, 501.4, 524.7, 533.7}, 5.61},
                                      {"200 kPa, 0.88 % roots", {363.9, 538.0, 618.5, 651.7, 664.6}, 5.99},
                                      {"300 kPa, bare", {468.1, 665.2, 752.0, 787.1, 800.6}, 5.61},
                                      {"300 kPa, 0.88 % roots", {545.9, 807.0, 927.8, 977.6, 996.9}, 5.99}}};

TEST(TriaxialLoess, AgreesWithAnIndependentIntegration) {
  const input::LoadedCase loaded =
      input::read_case(TALUS_SOURCE_DIR "/examples/triaxial_loess/case.toml", {}, input::CaseScope::whole_or_tests);
  EXPECT_FALSE(loaded.is_whole);
  ASSERT_EQ(loaded.data.tests.size(), 12u);
  for (const Published& published : table) {
    std::size_t i = 0;
    while (i < 12 && loaded.data.tests[i].name != published.test) ++i;
    ASSERT_LT(i, 12u) << published.test;
    const input::PointTest& test = loaded.data.tests[i];
    const PointCurve curve = run_point_test(loaded.data.test_soils[i], test);
    for (std::size_t k = 0; k < 5; ++k) {
      const auto q = find_point_result(curve, test, {test.name, "q", 0.05 * static_cast<double>(k + 1)});
      ASSERT_TRUE(q.has_value()) << published.test;
      EXPECT_NEAR(*q / 1e3, published.q[k], 0.005 * published.q[k]) << published.test << ", " << k;
    }
    EXPECT_NEAR(100 * *find_point_result(curve, test, {test.name, "volumetric_strain", 0.2}), published.volumetric,
                0.005 * published.volumetric + 0.005)
        << published.test;
  }
}

TEST(TriaxialLoess, RootsStrengthenAtEveryPressure) {
  const input::LoadedCase loaded =
      input::read_case(TALUS_SOURCE_DIR "/examples/triaxial_loess/case.toml", {}, input::CaseScope::whole_or_tests);
  for (std::size_t i = 0; i < loaded.data.tests.size(); ++i) {
    if (i % 4 == 0) continue;
    const double q = run_point_test(loaded.data.test_soils[i], loaded.data.tests[i]).rows.back().q;
    EXPECT_GT(q, run_point_test(loaded.data.test_soils[i - 1], loaded.data.tests[i - 1]).rows.back().q)
        << loaded.data.tests[i].name;
  }
}

}  // namespace
}  // namespace talus::laboratory
