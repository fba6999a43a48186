// SPDX-License-Identifier: MIT
// The time of failure from factors over time, with the scatter of the search.

#include <gtest/gtest.h>

#include "results/timeline.hpp"

namespace talus::results {
namespace {

Timeline follow(const std::vector<std::optional<double>>& factors) {
  Timeline timeline;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    timeline.factors.emplace_back().time = 3600.0 * static_cast<double>(i);
    timeline.factors.back().factor = factors[i];
  }
  find_failure(timeline);
  return timeline;
}

TEST(FailureTime, LiesBetweenTimesThatWereTried) {
  const Timeline t = follow({1.2, 1.1, 0.9, 0.8, 1.3});
  ASSERT_TRUE(t.failure);
  EXPECT_EQ(t.failure->from, 3600);
  EXPECT_EQ(t.failure->to, 7200);
  EXPECT_EQ(t.failure->earliest, 3600);
  EXPECT_EQ(t.failure->latest, 7200);
  EXPECT_EQ(t.least, 0.8);
  EXPECT_EQ(t.least_time, 3 * 3600.0);
  EXPECT_EQ(format_failure(t),
            "The factor of safety falls below 1 between 60 min and 2 h, where it is 1.1000 and 0.9000. It is least at "
            "3 h, 0.800.");
}

TEST(FailureTime, HoldsWhatSearchesScatter) {
  const Timeline t = follow({1.002, 1.001, 0.999, 0.998, 0.99});
  ASSERT_TRUE(t.failure);
  EXPECT_EQ(t.failure->earliest, 0);
  EXPECT_EQ(t.failure->latest, 4 * 3600.0);
  EXPECT_NE(format_failure(t).find("Allowing ± 0.3 % for the search, it fails between 0 s and 4 h."),
            std::string::npos);
}

TEST(FailureTime, MayBeNone) {
  EXPECT_NE(format_failure(follow({1.02, 0.999, 1.1})).find("after 0 s, or not at all"), std::string::npos);
  EXPECT_FALSE(follow({1.2, 1.0, 1.1}).failure);
  EXPECT_TRUE(follow({0.9, 1.1}).fails_from_start);
  EXPECT_EQ(format_failure(follow({std::nullopt})), "No slip surface was admissible at any time.");
}

TEST(FailureTime, ATimeWithoutFactorIsPassedOver) {
  const Timeline t = follow({1.2, std::nullopt, 0.9});
  ASSERT_TRUE(t.failure);
  EXPECT_EQ(t.failure->from, 0);
  EXPECT_EQ(t.failure->to, 7200);
}

}  // namespace
}  // namespace talus::results
