// SPDX-License-Identifier: MIT
// Warnings on water tables that are physically impossible or end inside the section, and none on plausible ones.

#include "site/site.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace talus::site {
namespace {

const Polyline slope{{0, 15}, {16, 15}, {34, 5}, {50, 5}};

/// The sentences on a water table, one after the other.
std::string describe(const Polyline& table, const Polyline& ground = slope) {
  std::string text;
  for (const std::string& sentence : find_odd_water(table, ground, 0, {"m", 1}, "The water table"))
    text += (text.empty() ? "" : "\n") + sentence;
  return text;
}

std::string describe_mirrored(Polyline table) {
  Polyline ground = slope;
  for (Polyline* line : {&table, &ground}) {
    for (Point& p : *line) p[0] = 50 - p[0];
    std::reverse(line->begin(), line->end());
  }
  return describe(table, ground);
}

TEST(OddWater, ExcludesPondsAndSeepage) {
  for (const Polyline& table : std::vector<Polyline>{{{0, 12}, {16, 11}, {34, 5}, {50, 5}},
                                                     {{0, 12}, {34, 5}},
                                                     {{0, 8}, {28, 8}, {50, 8}},
                                                     {{0, 12}, {25, 10}, {50, 10}},
                                                     {{0, 10}},
                                                     {{0, 15}, {16, 15}, {34, 5}, {50, 5}},
                                                     {{0, 20}},
                                                     {{0, 12}, {16, 11}, {34, 5.05}, {50, 5.05}}}) {
    EXPECT_EQ(describe(table), "");
    EXPECT_EQ(describe_mirrored(table), "");
  }
}

TEST(OddWater, ThatEndsInsideTheSectionFloodsTheToe) {
  EXPECT_EQ(
      describe({{0, 12}, {16, 11}}),
      "The water table ends at x = 16 m, inside the section, and continues level at y = 11 m: there it floods the "
      "ground up to 6 m deep. Give its points up to x = 50 m");
  EXPECT_NE(describe_mirrored({{0, 12}, {16, 11}}).find("ends at x = 34 m, inside the section"), std::string::npos);
  EXPECT_EQ(describe({{0, 12}, {16, 11}, {34, 5}}), "") << "it ends on the ground";
}

TEST(OddWater, PondsAreLevel) {
  const std::string message = describe({{0, 12}, {20, 12}, {34, 7}, {50, 6}});
  EXPECT_NE(message.find("standing water is level"), std::string::npos) << message;
  EXPECT_NE(message.find("between y = 6 m and"), std::string::npos) << message;
  EXPECT_NE(describe_mirrored({{0, 12}, {20, 12}, {34, 7}, {50, 6}}).find("standing water is level"),
            std::string::npos);
}

TEST(OddWater, FarAboveOrOutside) {
  EXPECT_EQ(describe({{0, 90}}),
            "The water table is at least 75 m above the highest ground: the whole section is under water");
  EXPECT_NE(describe({{100, 12}, {120, 5}}).find("outside the section, which runs from 0 m to 50 m"),
            std::string::npos);
  EXPECT_NE(describe({{0, -3}, {50, -4}}).find("lies below the section"), std::string::npos);
}

}  // namespace
}  // namespace talus::site
