// SPDX-License-Identifier: MIT
// Numbers in sentences, rounded by their uncertainty, and the uncertainty from two meshes.

#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "results/runout.hpp"

namespace talus {
namespace {

TEST(Uncertain, TheValueEndsWhereItsUncertaintyDoes) {
  EXPECT_EQ(format_uncertain(1.2508, 0.3582), "1.3 ± 0.4");
  EXPECT_EQ(format_uncertain(1.2508, 0.1182), "1.25 ± 0.12");
  EXPECT_EQ(format_uncertain(132.4, 23.1), "130 ± 20");
  EXPECT_EQ(format_uncertain(0.9714, 2.8), "1 ± 3");
  EXPECT_EQ(format_uncertain(-0.0614, 0.0004), "-0.0614 ± 0.0004");
  EXPECT_EQ(format_uncertain(-0.04, 0.3), "0.0 ± 0.3") << "nothing has a sign";
  EXPECT_EQ(format_uncertain(0.2, 0.096), "0.20 ± 0.10");
  EXPECT_EQ(format_uncertain(5, 0.995), "5.0 ± 1.0");
  EXPECT_EQ(format_uncertain(0, 0.5), "0.0 ± 0.5");
}

TEST(Uncertain, RoundingIsNaN) {
  EXPECT_EQ(format_uncertain(7e-18, std::nullopt), "0");
  EXPECT_EQ(format_uncertain(-7e-18, 3e-17), "0");
  EXPECT_EQ(format_uncertain(5.4321, 3e-16), "5.43") << "two meshes that agree";
  EXPECT_EQ(format_uncertain(5.4321, 1e-3), "5.43");
  EXPECT_EQ(format_uncertain(std::numeric_limits<double>::quiet_NaN(), 1.0), "–");
  EXPECT_EQ(format_uncertain(1.0, std::numeric_limits<double>::infinity()), "–");
}

TEST(Uncertain, WithoutAnUncertaintyTwoDigitsAreMeant) {
  EXPECT_EQ(format_uncertain(78.26, std::nullopt), "78");
  EXPECT_EQ(format_uncertain(1234.5, std::nullopt), "1200");
  EXPECT_EQ(format_uncertain(2.19, std::nullopt), "2.2");
  EXPECT_EQ(format_uncertain(0.0615, std::nullopt), "0.062");
  EXPECT_EQ(format_uncertain(0, std::nullopt), "0");
  EXPECT_EQ(format_uncertain(2.1949, 0.0), "2.19") << "two meshes agree";
}

TEST(Uncertain, OfTwoMeshesIsThreeTimesTheirDifference) {
  // A first-order error: at h it is e, at 2h 2e. The limit lies e away, a third of what is stated.
  const double limit = 5, error = 0.2;
  EXPECT_NEAR(results::find_mesh_uncertainty(limit + error, limit + 2 * error), 3 * error, 1e-12);
  EXPECT_NEAR(results::find_mesh_uncertainty(limit - error, limit - 2 * error), 3 * error, 1e-12);
  results::Runout runout;
  EXPECT_FALSE(results::RunoutUncertainty(runout).front_advance) << "one mesh has none";
  runout.front_advance = 1.2;
  runout.coarser_mesh = {0.5, 1.1};
  EXPECT_NEAR(*results::RunoutUncertainty(runout).front_advance, 0.3, 1e-12);
}

}  // namespace
}  // namespace talus
