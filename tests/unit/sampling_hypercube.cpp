// SPDX-License-Identifier: MIT
// Latin hypercube sampling: classes, correlations, and variance reduction against random samples.

#include "study/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "study/sampling_table.hpp"

namespace talus::study {
namespace {

ScorePlan make_plan(int samples, int numbers, bool latin, std::uint64_t seed = 1) {
  ScorePlan plan;
  plan.samples = samples;
  plan.numbers = numbers;
  plan.latin = latin;
  plan.seed = seed;
  return plan;
}

TEST(LatinHypercube, HasEveryClassOnceInEveryReplicate) {
  ScorePlan plan = make_plan(1003, 3, true);
  plan.replicates = 4;
  plan.correlation = {1, -0.5, 0.2, -0.5, 1, 0, 0.2, 0, 1};
  const auto scores = draw_scores(plan);
  for (const auto& column : scores)
    for (int r = 0; r < plan.replicates; ++r) {
      const int first = find_first(plan, r), count = find_first(plan, r + 1) - first;
      std::vector<int> seen(static_cast<std::size_t>(count));
      for (int i = 0; i < count; ++i)
        ++seen.at(
            static_cast<std::size_t>(find_normal_probability(column[static_cast<std::size_t>(first + i)]) * count));
      for (const int n : seen) ASSERT_EQ(n, 1);
    }
}

TEST(LatinHypercube, HasTheGivenCorrelation) {
  ScorePlan plan = make_plan(2000, 3, true);
  plan.correlation = {1, -0.7, 0.3, -0.7, 1, 0.1, 0.3, 0.1, 1};
  const auto latin = draw_scores(plan);
  plan.latin = false;
  const auto random = draw_scores(plan);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NEAR(correlate(latin[i], latin[j]), plan.correlation[3 * i + j], 0.005);
      EXPECT_NEAR(correlate(random[i], random[j]), plan.correlation[3 * i + j], 4.0 / std::sqrt(2000.0));
    }
  // The copula is Gaussian: so many samples lie in the lower left quarter (Sheppard 1899).
  long both = 0;
  for (std::size_t i = 0; i < 2000; ++i) both += latin[0][i] < 0 && latin[1][i] < 0 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(both) / 2000, 0.25 + std::asin(-0.7) / (2 * M_PI), 0.02);
}

TEST(LatinHypercube, OfFewSamplesStillPairsThem) {
  ScorePlan plan = make_plan(5, 4, true);
  const auto scores = draw_scores(plan);
  for (const auto& column : scores) {
    EXPECT_NEAR(find_moments(column).mean, 0, 0.5);
    for (const double z : column) EXPECT_TRUE(std::isfinite(z));
  }
}

TEST(LatinHypercube, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(draw_scores(make_plan(50, 2, true, 3)), draw_scores(make_plan(50, 2, true, 3)));
  EXPECT_NE(draw_scores(make_plan(50, 2, true, 3)), draw_scores(make_plan(50, 2, true, 4)));
}

/// 200 repetitions of the mean of a nearly additive function: the variance of a hypercube's mean is a small part of
/// that of random samples (McKay, Beckman and Conover 1979), and the mean is right.
TEST(LatinHypercube, GainsOverRandomSamplesWhereANumberActsByItself) {
  std::vector<double> latin, random;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    for (const bool is_latin : {true, false}) {
      const auto z = draw_scores(make_plan(100, 3, is_latin, seed));
      double mean = 0;
      for (std::size_t i = 0; i < 100; ++i) mean += (std::exp(0.3 * z[0][i]) + z[1][i] + 0.1 * z[0][i] * z[2][i]) / 100;
      (is_latin ? latin : random).push_back(mean);
    }
  const results::SampledValues a = find_moments(latin), b = find_moments(random);
  EXPECT_LT(a.deviation, 0.15 * b.deviation);
  EXPECT_NEAR(a.mean, std::exp(0.045), 4 * a.deviation / std::sqrt(200.0) + 2e-4);
  EXPECT_NEAR(b.mean, std::exp(0.045), 4 * b.deviation / std::sqrt(200.0));
}

}  // namespace
}  // namespace talus::study
