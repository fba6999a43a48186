// SPDX-License-Identifier: MIT
// Richardson extrapolation of a study: exact power laws are recovered, and scatter is reported.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

std::vector<double> follow(const std::vector<double>& sizes, double limit, double slope, double order) {
  std::vector<double> factors;
  for (const double h : sizes) factors.push_back(limit + slope * std::pow(h, order));
  return factors;
}

TEST(Richardson, FindsLimitAndOrderOfAPowerLaw) {
  const std::vector<double> sizes{1.5, 1.06, 0.75, 0.53, 0.375};
  for (const double order : {0.6, 1.0, 1.7, 2.0}) {
    const results::ExtrapolatedFactor e = extrapolate(sizes, follow(sizes, 1.376, 0.11, order));
    ASSERT_TRUE(e.order);
    EXPECT_NEAR(*e.order, order, 1e-3);
    EXPECT_NEAR(*e.by_order, 1.376, 1e-4);
  }
}

TEST(Richardson, ALineIsExactAndHasNoError) {
  const results::ExtrapolatedFactor e = extrapolate({0.5, 2, 1}, {1.45, 1.60, 1.50});  // given in any order
  EXPECT_EQ(e.sizes, (std::vector<double>{2, 1, 0.5}));
  EXPECT_NEAR(e.linear, 1.40, 1e-12);
  EXPECT_NEAR(e.finest_pair, 1.40, 1e-12);
  EXPECT_NEAR(*e.standard_error, 0, 1e-12);
}

/// Meshes scatter; the standard error must be that of the intercept, found here from the textbook's sums.
TEST(Richardson, GivesTheErrorOfScatteredMeshes) {
  const results::ExtrapolatedFactor e = extrapolate({4, 3, 2, 1}, {1.41, 1.29, 1.21, 1.09});
  EXPECT_NEAR(e.linear, 0.990, 1e-12);  // slope 0.104
  const double s2 = (0.004 * 0.004 + 0.012 * 0.012 + 0.012 * 0.012 + 0.004 * 0.004) / 2;
  EXPECT_NEAR(*e.standard_error, std::sqrt(s2 * (1.0 / 4 + 2.5 * 2.5 / 5)), 1e-12);
}

TEST(Richardson, RefusesWhatCannotBeExtrapolated) {
  EXPECT_THROW(extrapolate({1}, {1.4}), Error);
  EXPECT_THROW(extrapolate({1, 1}, {1.4, 1.5}), Error);
  EXPECT_THROW(extrapolate({1, 0}, {1.4, 1.5}), Error);
}

}  // namespace
}  // namespace talus::study
