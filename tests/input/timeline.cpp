// SPDX-License-Identifier: MIT
// [timeline]: moments as times or as dates.

#include "wet_slope.hpp"

namespace talus::input {
namespace {

constexpr double one_day = 86400;

/// The wet slope from 2023-03-01 on, with LEM; `timeline` holds the keys of [timeline].
std::string write_case(const std::string& timeline, const std::string& date = "date = 2023-03-01\n") {
  std::string text = change(wet_slope, "pore_pressure = \"seepage\"", date + "pore_pressure = \"seepage\"");
  text = change(text, "kind = \"strength_reduction\"", "kind = \"run\"\nmethods = [\"lem\", \"fem\", \"mpm\"]");
  return text + "[timeline]\nuntil = 2023-03-11\n" + timeline;
}

TEST(TimelineDates, AreTimesSinceTheDateOfTimeZero) {
  const Timeline timeline =
      *read_case_text(write_case("dates = [2023-03-02, \"2023-03-04 12:00\", 2023-03-11]\n"
                                 "element_dates = [2023-03-11]\n[timeline.release]\ndate = \"2023-03-04 12:00\"\n"),
                      "slope.toml")
           .data.timeline;
  EXPECT_EQ(timeline.duration, 10 * one_day);
  EXPECT_EQ(timeline.times, (std::vector<double>{one_day, 3.5 * one_day, 10 * one_day}));
  EXPECT_EQ(timeline.element_times, std::vector<double>{10 * one_day});
  EXPECT_EQ(timeline.release->time, 3.5 * one_day);
  EXPECT_TRUE(timeline.dates.empty());
}

TEST(TimelineDates, NeedTheDateOfTimeZero) {
  const std::string text = change(write_case("dates = @@[2023-03-02]\n", ""), "until = 2023-03-11", "duration = 10");
  expect_fault(text, "a list of dates needs [initial] date, the date of time 0");
}

TEST(PoolLoading, NeedsASoilThatGivesWay) {
  expect_fault(write_case("pool_loading = @@true\n"), "a `compressibility` in [materials.NAME.water] is missing");
}

TEST(TimelineDates, AreNamedWhereTheyAreWrong) {
  expect_fault(write_case("dates = @@[2023-03-02, 2023-03-12]\n"), "is outside the timeline");
  expect_fault(write_case("dates = @@[2023-02-02]\n"), "is outside the timeline");
  expect_fault(write_case("dates = @@[2023-03-03, 2023-03-02]\n"), "the times must increase");
  expect_fault(write_case("dates = [2023-03-02, @@\"soon\"]\n"), "must be a date such as 2023-07-01");
  expect_fault(write_case("dates = @@2023-03-02\n"), "must be a list of dates");
  expect_fault(write_case("times = [1]\ndates = @@[2023-03-02]\n"), "where 'times' is given");
  expect_fault(write_case("dates = [2023-03-02]\nelement_dates = @@[2023-03-03]\n"), "is not one of [timeline] times");
  expect_fault(write_case("dates = [2023-03-02]\n[timeline.release]\ndate = @@2023-03-03\n"),
               "is not one of [timeline] times");
}

}  // namespace
}  // namespace talus::input
