// SPDX-License-Identifier: MIT
// The bracketed search of back-analysis, on functions with known roots: smooth, stepped, jumping, non-monotone and
// undefined in places.
#include "study/root_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace talus::study {
namespace {

using results::BackAnalysisEnd;

struct Search {
  RootFinding found;
  std::set<double> tried;
};

Search search(const RootOptions& options, const std::function<Sample(double)>& function) {
  Search search;
  search.found = search_root(options, [&](double x) {
    EXPECT_TRUE(search.tried.insert(x).second) << "evaluated twice: " << x;
    EXPECT_TRUE(options.range.holds(x)) << x;
    return function(x);
  });
  return search;
}

Search search_value(const RootOptions& options, const std::function<std::optional<double>(double)>& function) {
  return search(options, [&](double x) { return Sample{x, function(x), {}, {}}; });
}

RootOptions start_at(double x, double low = -INFINITY, double high = INFINITY) {
  RootOptions options;
  options.start = x, options.step = 0.5 * std::abs(x);
  options.range.low = low, options.range.high = high;
  return options;
}

RootOptions search_between(double low, double high) {
  RootOptions options;
  options.range = {low, high, false, false};
  options.is_given = true;
  return options;
}

TEST(RootSearch, AProportionalResultHasAnExactRootFromAnyStart) {
  for (const double start : {0.01, 3.0, 30.0, 7000.0}) {
    const Search s = search_value(start_at(start, 0), [](double x) { return x / 25.7; });
    ASSERT_EQ(s.found.end, BackAnalysisEnd::found) << start;
    EXPECT_NEAR(*s.found.x, 25.7, 1e-9 * 25.7) << start;
    EXPECT_LE(s.found.bracket->high - s.found.bracket->low, 1e-3 * s.found.bracket->high);
    EXPECT_TRUE(s.found.others.empty());
    EXPECT_FALSE(s.found.largest_reversal);
  }
}

TEST(RootSearch, CurvedResultsNeedFewRuns) {
  const std::vector<std::pair<double, std::function<double(double)>>> cases = {
      {std::cbrt(2.0), [](double x) { return x * x * x - 1; }},
      {std::log(3.0), [](double x) { return std::exp(x) - 2; }},
      {0.25, [](double x) { return 2 * std::sqrt(x); }},
      {4.0, [](double x) { return 4 / x; }},
      {std::tan(0.6), [](double x) { return std::atan(x) / 0.6; }}};
  for (const auto& [root, function] : cases) {
    const Search s = search_value(start_at(1, 0), function);
    ASSERT_TRUE(s.found.x);
    EXPECT_NEAR(*s.found.x, root, 1e-5 * root);
    EXPECT_LE(s.tried.size(), 11U) << root;
    EXPECT_TRUE(s.found.bracket->low <= root && root <= s.found.bracket->high);
  }
}

TEST(RootSearch, ARootThatIsEvaluatedIsExact) {
  const Search s = search_value(search_between(0, 2), [](double x) { return x; });
  ASSERT_TRUE(s.found.x);
  EXPECT_EQ(*s.found.x, 1);
  EXPECT_EQ(s.found.bracket->low, s.found.bracket->high);
}

TEST(RootSearch, ADecreasingResultIsFollowedDownwardsAndThroughZero) {
  const Search s = search_value(start_at(0.1), [](double x) { return 1 / (1.2 + 2 * x); });
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, -0.1, 1e-5);
}

TEST(RootSearch, TheLimitOfTheRangeIsTried) {
  const Search s = search_value(start_at(10, 0), [](double x) { return 1 + 1e-9 + x; });
  EXPECT_EQ(s.found.end, BackAnalysisEnd::not_reached);
  EXPECT_EQ(s.found.samples.front().x, 0);
  EXPECT_LE(s.tried.size(), 12U);
}

TEST(RootSearch, ResultsThatDoNotDependOnTheKeyAreNoted) {
  const Search s = search_value(start_at(10, 0), [](double) { return 1.4; });
  EXPECT_EQ(s.found.end, BackAnalysisEnd::no_effect);
  EXPECT_LE(s.tried.size(), 7U);
}

TEST(RootSearch, AJumpOverTheTargetHasNoValue) {
  const Search s =
      search_value(search_between(0, 10), [](double x) { return x < 4.321 ? 0.8 + 0.01 * x : 1.1 + 0.01 * x; });
  EXPECT_EQ(s.found.end, BackAnalysisEnd::jump);
  EXPECT_FALSE(s.found.x);
  ASSERT_TRUE(s.found.bracket);
  EXPECT_LT(s.found.bracket->low, 4.321);
  EXPECT_GE(s.found.bracket->high, 4.321);
  EXPECT_LE(s.found.bracket->high - s.found.bracket->low, 1e-3 * 4.33);
}

TEST(RootSearch, ScatterNarrowsTheBracketAllTheSame) {
  // The scatter of a search for slip surfaces, 0.2 %.
  const Search s =
      search_value(search_between(5, 50), [](double x) { return (x / 20) * (1 + 0.001 * std::sin(1e5 * x)); });
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, 20, 0.04);
  EXPECT_FALSE(s.found.largest_reversal);
}

TEST(RootSearch, AResultInStepsIsNotNarrowedBeyondItsResolution) {
  const Search s = search(search_between(5, 50), [](double x) {
    const double step = 0.01;
    return Sample{x, (std::floor(x / 20 / step) + 0.5) * step, {}, {}, step};
  });
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, 20, 0.3);
  EXPECT_GT(s.found.bracket->high - s.found.bracket->low, 1e-3 * 20);
  EXPECT_EQ(s.found.end, BackAnalysisEnd::found);
}

TEST(RootSearch, SeveralRootsAreListed) {
  // A parabola with roots at 3 and 5. The first step from 5.5 goes beyond both.
  const auto parabola = [](double x) { return 1 + (x - 3) * (x - 5); };
  const Search inside = search_value(search_between(0, 8), parabola);
  ASSERT_TRUE(inside.found.x) << "both ends are above the target, the middle is not";
  EXPECT_EQ(inside.found.others.size(), 1U);
  ASSERT_TRUE(inside.found.largest_reversal);
  const Search s = search_value(start_at(5.5, 0), parabola);
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, 5, 1e-3);
  EXPECT_EQ(s.found.others.size(), 1U);
}

TEST(RootSearch, UndefinedEndsOfTheRangeAreApproached) {
  const Search s = search_value(search_between(0, 64),
                                [](double x) { return x > 3 && x < 50 ? std::optional(x / 5) : std::nullopt; });
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, 5, 1e-5);
}

TEST(RootSearch, AnUndefinedPlaceInTheBracketIsAvoided) {
  const Search beside = search_value(search_between(0, 10),
                                     [](double x) { return x > 4.5 && x < 5.5 ? std::nullopt : std::optional(x / 3); });
  ASSERT_TRUE(beside.found.x);
  EXPECT_NEAR(*beside.found.x, 3, 1e-5);
  const Search around = search_value(search_between(0, 10),
                                     [](double x) { return x > 2 && x < 7 ? std::nullopt : std::optional(x / 5); });
  EXPECT_EQ(around.found.end, BackAnalysisEnd::gap);
  EXPECT_FALSE(around.found.x);
  EXPECT_LE(around.found.bracket->low, 2);
  EXPECT_GE(around.found.bracket->high, 7);
}

TEST(RootSearch, TheExpansionCrossesAnUndefinedPlace) {
  const Search s =
      search_value(start_at(1, 0), [](double x) { return x > 1.4 && x < 2 ? std::nullopt : std::optional(x / 3); });
  ASSERT_TRUE(s.found.x);
  EXPECT_NEAR(*s.found.x, 3, 1e-5);
}

TEST(RootSearch, NothingDefinedIsNoResult) {
  const auto none = [](double) { return std::optional<double>(); };
  EXPECT_EQ(search_value(search_between(1, 2), none).found.end, BackAnalysisEnd::no_result);
  EXPECT_EQ(search_value(start_at(1), none).found.end, BackAnalysisEnd::no_result);
}

TEST(RootSearch, TheIntervalEndsWhereItsOwnLimitsReachTheTarget) {
  for (const bool falls : {false, true}) {
    const Search s = search(start_at(40, 0), [&](double x) {
      const double y = falls ? 25 / x : x / 25;
      return Sample{x, y, 0.98 * y, 1.03 * y};
    });
    ASSERT_TRUE(s.found.x && s.found.low && s.found.high);
    EXPECT_NEAR(*s.found.x, 25, 1e-4);
    const double weak = falls ? 25 * 0.98 : 25 / 1.03, strong = falls ? 25 * 1.03 : 25 / 0.98;
    // The ends are arguments whose interval excludes the target, at most a tenth too far out.
    EXPECT_LE(*s.found.low, weak);
    EXPECT_NEAR(*s.found.low, weak, 0.15 * (25 - weak));
    EXPECT_GE(*s.found.high, strong);
    EXPECT_NEAR(*s.found.high, strong, 0.15 * (strong - 25));
  }
}

TEST(RootSearch, AnIntervalThatLeavesTheRangeHasOneEnd) {
  const Search s = search(search_between(10, 25.1), [](double x) {
    return Sample{x, x / 25, 0.9 * x / 25, 1.1 * x / 25};
  });
  ASSERT_TRUE(s.found.x && s.found.low);
  EXPECT_FALSE(s.found.high);
}

TEST(RootSearch, RoundsToTheFewestDigits) {
  EXPECT_EQ(round_within(12.3456, 0.5), 12);
  EXPECT_EQ(round_within(12.3456, 0.1), 12.3);
  EXPECT_EQ(round_within(-0.0123456, 1e-5), -0.01235);
  EXPECT_EQ(round_within(0, 1e-9), 0);
}

/// Runs whose result is one end of its own interval, as a bound of limit analysis is.
TEST(RootSearch, TheIntervalOfABoundLiesOnItsOwnSide) {
  for (int i = 0; i <= 40; ++i) {
    const double root = 18 + 0.1371 * i;
    const Search upper = search(start_at(20, 0), [&](double x) {
      return Sample{x, x / root, 0.95 * x / root, x / root};
    });
    ASSERT_TRUE(upper.found.x && upper.found.low && upper.found.high) << root;
    EXPECT_NEAR(*upper.found.low, root, 2e-3 * root);
    // The end is a run that excludes the target.
    EXPECT_GE(*upper.found.high, root / 0.95);
    EXPECT_LE(*upper.found.high, 1.01 * root / 0.95);
    const Search falling = search(start_at(20, 0.01), [&](double x) {
      return Sample{x, root / x, root / x, 1.05 * root / x};
    });
    ASSERT_TRUE(falling.found.x && falling.found.low && falling.found.high) << root;
    EXPECT_NEAR(*falling.found.low, root, 2e-3 * root);
    EXPECT_GE(*falling.found.high, 1.05 * root);
    EXPECT_LE(*falling.found.high, 1.01 * 1.05 * root);
  }
}

TEST(RootSearch, RunsWithoutIntervalsLeaveTheRoot) {
  const Search s = search(start_at(20, 0), [](double x) {
    const double y = x / 25.3;
    return x > 25.4 && x < 30 ? Sample{x, y, {}, {}} : Sample{x, y, 0.97 * y, 1.03 * y};
  });
  ASSERT_EQ(s.found.end, BackAnalysisEnd::found);
  EXPECT_NEAR(*s.found.x, 25.3, 1e-3 * 25.3);
}

TEST(RootSearch, ARootAtTheStartHasBothEndsOfItsInterval) {
  const Search s = search(start_at(20, 0), [](double x) {
    const double y = x / 20;
    return Sample{x, y, 0.95 * y, 1.05 * y};
  });
  ASSERT_TRUE(s.found.x && s.found.low && s.found.high);
  EXPECT_EQ(*s.found.x, 20);
  EXPECT_NEAR(*s.found.low, 20 / 1.05, 0.02 * 20);
  EXPECT_NEAR(*s.found.high, 20 / 0.95, 0.02 * 20);
}

TEST(RootSearch, ABracketWithoutNeighboursIsNoJump) {
  RootOptions options = search_between(19, 20);
  options.tolerance = 0.05;
  EXPECT_EQ(search_value(options, [](double x) { return x / 19.5; }).found.end, BackAnalysisEnd::found);
}

TEST(RootSearch, ScatterHidesNoJump) {
  for (int i = 0; i < 60; ++i) {
    const Search s = search_value(start_at(20, 0), [&](double x) {
      const double noise = 1e-3 * std::sin(1e5 * x + i);
      return x / 25 * (1 + noise) + (x < 24.9 ? -0.02 : 0.02);
    });
    EXPECT_EQ(s.found.end, BackAnalysisEnd::jump) << i;
  }
}

/// Searches whole numbers and returns those that were tried.
Search search_steps(RootOptions options, const std::function<std::optional<double>(double)>& function) {
  Search search;
  search.found = search_whole_number(options, [&](double x) {
    EXPECT_EQ(x, std::floor(x));
    EXPECT_TRUE(search.tried.insert(x).second) << "evaluated twice: " << x;
    EXPECT_TRUE(options.range.holds(x)) << x;
    return Sample{x, function(x), {}, {}};
  });
  return search;
}

TEST(WholeNumberSearch, FindsTheSmallestNumberThatMeetsTheTarget) {
  for (const double start : {1.0, 2.0, 6.0, 7.0, 40.0, 200.0}) {
    const Search s = search_steps(start_at(start, 1, 200), [](double n) { return 0.15 * n; });
    ASSERT_EQ(s.found.end, BackAnalysisEnd::found) << start;
    EXPECT_EQ(*s.found.x, 7) << start;
    EXPECT_EQ(s.found.bracket->low, 6);
    EXPECT_EQ(s.found.bracket->high, 7);
    EXPECT_TRUE(s.tried.count(6) && s.tried.count(7));
    EXPECT_LE(s.tried.size(), 15U) << start;
  }
  EXPECT_EQ(*search_steps(start_at(3, 1, 200), [](double n) { return n / 8; }).found.x, 8) << "exactly the target";
}

TEST(WholeNumberSearch, FindsTheLargestNumberOfAFallingResult) {
  const Search s = search_steps(start_at(1, 1, 200), [](double n) { return 12.5 / n; });
  EXPECT_EQ(*s.found.x, 12);
  EXPECT_EQ(s.found.bracket->high, 13);
  const Search given = search_steps(search_between(4, 90), [](double n) { return 12.5 / n; });
  EXPECT_EQ(*given.found.x, 12);
}

TEST(WholeNumberSearch, StopsWhereNumbersHaveNoResult) {
  // Rows beyond the foot of the slope are faults of the case.
  const auto until = [](double last) {
    return [last](double n) { return n <= last ? std::optional(0.15 * n) : std::nullopt; };
  };
  EXPECT_EQ(*search_steps(start_at(2, 1, 200), until(7)).found.x, 7);
  const Search none = search_steps(start_at(2, 1, 200), until(6));
  EXPECT_EQ(none.found.end, BackAnalysisEnd::not_reached);
  EXPECT_TRUE(none.tried.count(6) && none.tried.count(7)) << "the last number with a result was tried";
  EXPECT_EQ(search_steps(start_at(2, 1, 200), [](double) { return std::nullopt; }).found.end,
            BackAnalysisEnd::no_result);
  EXPECT_EQ(search_steps(start_at(2, 1, 200), [](double) { return 0.7; }).found.end, BackAnalysisEnd::no_effect);
}

TEST(WholeNumberSearch, GapsAndReversalsAreNamed) {
  const Search gap = search_steps(start_at(1, 1, 200),
                                  [](double n) { return n > 5 && n < 8 ? std::nullopt : std::optional(0.15 * n); });
  EXPECT_EQ(gap.found.end, BackAnalysisEnd::gap);
  EXPECT_EQ(gap.found.bracket->low, 5);
  EXPECT_EQ(gap.found.bracket->high, 8);
  EXPECT_FALSE(gap.found.x);
  const Search wave =
      search_steps(search_between(1, 9), [](double n) { return n == 1 || n > 5 ? 1.2 : 0.9 + 0.01 * n; });
  EXPECT_TRUE(wave.found.x);
  EXPECT_TRUE(wave.found.largest_reversal || !wave.found.others.empty());
}

}  // namespace
}  // namespace talus::study
