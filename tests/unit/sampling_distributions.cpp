// SPDX-License-Identifier: MIT
// Random numbers against published values, distributions against closed forms.

#include "study/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus::study {
namespace {

using input::Distribution;
using Words = std::array<std::uint32_t, 4>;

Marginal make_marginal(Distribution kind, double mean, double deviation) {
  Marginal m;
  m.kind = kind;
  m.mean = mean;
  m.deviation = deviation;
  return m;
}

/// Mean and deviation by the midpoint rule over the probability.
std::pair<double, double> integrate(const Marginal& m) {
  constexpr int steps = 200000;
  double first = 0, second = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = m.find_value(find_normal_score((i + 0.5) / steps));
    first += x / steps;
    second += x * x / steps;
  }
  return {first, std::sqrt(second - first * first)};
}

/// Known-answer test vectors of Random123 (kat_vectors).
TEST(RandomStream, GivesThePublishedNumbersOfPhilox) {
  EXPECT_EQ(scramble({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(scramble({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}), (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(scramble({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, IsUniformAndDiffersBetweenStreams) {
  RandomStream a(7, 0), b(7, 1), again(7, 0);
  constexpr int count = 100000;
  std::array<int, 10> classes{};
  double product = 0;
  for (int i = 0; i < count; ++i) {
    const double x = a.draw_uniform(), y = b.draw_uniform();
    ASSERT_EQ(x, again.draw_uniform());
    ++classes[static_cast<std::size_t>(10 * x)];
    product += (x - 0.5) * (y - 0.5) / count;
  }
  for (const int n : classes) EXPECT_NEAR(n, count / 10, 4.5 * std::sqrt(0.09 * count));
  EXPECT_NEAR(product, 0, 4.5 / 12 / std::sqrt(count));
  std::array<int, 3> thirds{};
  for (int i = 0; i < 30000; ++i) ++thirds[a.draw_below(3)];
  for (const int n : thirds) EXPECT_NEAR(n, 10000, 400);
}

TEST(NormalLaw, ScoreAndProbabilityAreInverse) {
  for (const double p : {1e-300, 1e-100, 1e-20, 1e-6, 0.01, 0.3, 0.5, 0.7, 0.999, 1 - 1e-12})
    EXPECT_NEAR(find_normal_probability(find_normal_score(p)) / p, 1, 1e-10) << p;
  EXPECT_NEAR(find_normal_score(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(find_normal_score(1e-9), -5.997807015007687, 1e-12);
}

TEST(Distribution, LognormalHasItsClosedFormQuantiles) {
  const Marginal m = make_marginal(Distribution::lognormal, 18, 3.6);
  const double zeta = std::sqrt(std::log(1.04));
  EXPECT_NEAR(m.find_value(0), 18 / std::sqrt(1.04), 1e-12);  // the median
  EXPECT_NEAR(m.find_value(1.5), 18 / std::sqrt(1.04) * std::exp(1.5 * zeta), 1e-11);
  EXPECT_NEAR(integrate(m).first, 18, 1e-4);
  EXPECT_NEAR(integrate(m).second, 3.6, 2e-3);
}

TEST(Distribution, ProbabilityIsTheInverseOfValue) {
  Marginal cut = make_marginal(Distribution::normal, 5, 2);
  cut.lowest = 0;
  Marginal narrow = make_marginal(Distribution::lognormal, 5, 2);
  narrow.lowest = 6;
  narrow.highest = 7;
  Marginal triangle{Distribution::triangular, 0, 0, 10, 25, 14};
  Marginal flat{Distribution::uniform, 0, 0, -1, 3, 0};
  for (const Marginal& m : {make_marginal(Distribution::normal, -3, 2), make_marginal(Distribution::lognormal, 3, 2),
                            cut, narrow, triangle, flat})
    for (const double z : {-5.0, -2.0, -0.5, 0.0, 0.1, 1.0, 3.0}) {
      const double x = m.find_value(z);
      EXPECT_GE(x, m.lowest);
      EXPECT_LE(x, m.highest);
      EXPECT_NEAR(m.find_probability(x), find_normal_probability(z), 1e-11) << static_cast<int>(m.kind) << " at " << z;
    }
}

TEST(Distribution, MomentsOfACutOneAreThoseOfItsValues) {
  Marginal low = make_marginal(Distribution::normal, 5, 3);
  low.lowest = 1;
  Marginal both = make_marginal(Distribution::lognormal, 5, 3);
  both.lowest = 2;
  both.highest = 9;
  const Marginal triangle{Distribution::triangular, 0, 0, 10, 25, 14};
  const Marginal flat{Distribution::uniform, 0, 0, -1, 3, 0};
  for (const Marginal& m : {low, both, triangle, flat}) {
    const auto [mean, deviation] = integrate(m);
    EXPECT_NEAR(m.find_mean(), mean, 2e-4);
    EXPECT_NEAR(m.find_deviation(), deviation, 2e-3);
  }
  EXPECT_NEAR(low.find_cut_share(), find_normal_probability(-4.0 / 3), 1e-15);
  EXPECT_NEAR(triangle.find_mean(), 49.0 / 3, 1e-12);
  EXPECT_NEAR(flat.find_deviation(), 4 / std::sqrt(12.0), 1e-12);
}

/// Far in a tail the quantiles of a cut distribution keep their digits: P(X > x | X > 8) of a standard normal X.
TEST(Distribution, CutFarInTheTailKeepsItsDigits) {
  Marginal m = make_marginal(Distribution::normal, 0, 1);
  m.lowest = 8;
  const double x = m.find_value(1);
  EXPECT_NEAR(find_normal_probability(-x) / find_normal_probability(-8), find_normal_probability(-1), 1e-10);
}

TEST(Distribution, LognormalsHaveTheCorrelationOfTheClosedForm) {
  const Marginal a = make_marginal(Distribution::lognormal, 10, 4), b = make_marginal(Distribution::lognormal, 3, 0.6);
  const double za = std::sqrt(std::log(1.16)), zb = std::sqrt(std::log(1.04));
  for (const double r : {-0.7, 0.3, 0.9})
    EXPECT_NEAR(correlate_values(a, b, r), std::expm1(r * za * zb) / (0.4 * 0.2), 1e-9);
  const Marginal c = make_marginal(Distribution::normal, 1, 2);
  EXPECT_NEAR(correlate_values(c, c, -0.5), -0.5, 1e-12);
}

}  // namespace
}  // namespace talus::study
