// SPDX-License-Identifier: MIT
// Selection of times where a curve bends or crosses the target.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "run/timeline/times.hpp"

namespace talus::run {
namespace {

std::vector<double> choose(const std::function<double(double)>& factor, double tolerance, int most,
                           double* distance = nullptr) {
  std::vector<double> times;
  for (int i = 0; i <= 256; ++i) times.push_back(i / 256.0);
  TimeChoice choice(times, 1, tolerance, most);
  // Surfaces that are known are two per cent too strong.
  std::vector<std::optional<double>> guide;
  for (const double t : times) guide.push_back(1.02 * factor(t));
  choice.set_guide(guide);
  for (auto next = choice.next(); !next.empty(); next = choice.next())
    for (const std::size_t i : next) choice.set(i, factor(times[i]));
  if (distance != nullptr) *distance = choice.find_distance();
  std::vector<double> tried;
  for (const std::size_t i : choice.list_tried()) tried.push_back(times[i]);
  return tried;
}

TEST(TimelineChoice, AStraightLineNeedsTheFirstTimesOnly) {
  EXPECT_EQ(choose([](double t) { return 2 - 0.5 * t; }, 0.003, 40).size(), 5u);
}

TEST(TimelineChoice, AStepIsFoundBetweenNeighbours) {
  const auto tried = choose([](double t) { return t < 0.37 ? 1.2 : 0.9; }, 0.5, 40);
  const auto after = std::lower_bound(tried.begin(), tried.end(), 0.37);
  EXPECT_NEAR(*after - *(after - 1), 1 / 256.0, 1e-12);
}

TEST(TimelineChoice, BetweenItsTimesTheCurveIsStraight) {
  const auto factor = [](double t) { return 1.5 - 0.4 * std::exp(-200 * (t - 0.6) * (t - 0.6)); };
  double distance = 0;
  const auto tried = choose(factor, 0.003, 100, &distance);
  EXPECT_LE(distance, 0.003);
  for (std::size_t k = 0; k + 1 < tried.size(); ++k)
    for (int i = 1; i < 8; ++i) {
      const double fraction = i / 8.0, t = tried[k] + fraction * (tried[k + 1] - tried[k]);
      const double line = (1 - fraction) * factor(tried[k]) + fraction * factor(tried[k + 1]);
      EXPECT_NEAR(line / factor(t), 1, 0.004) << t;
    }
  EXPECT_LT(tried.size(), 40u);
}

TEST(TimelineChoice, ADipBetweenTheFirstTimesIsFound) {
  const auto factor = [](double t) { return 1.5 - 0.3 * std::exp(-5000 * (t - 0.37) * (t - 0.37)); };
  const auto tried = choose(factor, 0.003, 60);
  double least = 2;
  for (const double t : tried) least = std::min(least, factor(t));
  EXPECT_NEAR(least, 1.2, 0.002);
}

TEST(TimelineChoice, WithoutAGuideAPassageIsStillFound) {
  std::vector<double> times;
  for (int i = 0; i <= 100; ++i) times.push_back(i);
  TimeChoice choice(times, 1, 0.003, 40);
  const auto factor = [](double t) { return t < 61.5 ? 1.4 : 0.8; };
  for (auto next = choice.next(); !next.empty(); next = choice.next())
    for (const std::size_t i : next) choice.set(i, factor(times[i]));
  const auto tried = choice.list_tried();
  EXPECT_TRUE(std::count(tried.begin(), tried.end(), 61u) == 1 && std::count(tried.begin(), tried.end(), 62u) == 1);
}

TEST(TimelineChoice, NeverTriesMoreThanMost) {
  EXPECT_EQ(choose([](double t) { return 1.5 + std::sin(40 * t); }, 1e-6, 20).size(), 20u);
}

TEST(TimelineChoice, ATimeWithoutFactorBreaksNothing) {
  std::vector<double> times{0, 1, 2, 3, 4};
  TimeChoice choice(times, 1, 0.003, 5);
  for (const std::size_t i : choice.next())
    choice.set(i, i == 2 ? std::nullopt : std::optional<double>(i < 2 ? 1.1 : 0.9));
  EXPECT_TRUE(choice.next().empty());
  EXPECT_EQ(choice.find_distance(), 0);
}

}  // namespace
}  // namespace talus::run
