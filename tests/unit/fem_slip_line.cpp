// SPDX-License-Identifier: MIT
// Slip lines of given displacement fields: blocks that rotate on circles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/solid_model.hpp"

namespace talus {
namespace {

using Line = std::vector<std::array<double, 2>>;

constexpr double top = 10, height = 12, radius = 8;  ///< of the ground, of the centres and of their circles [m]
constexpr double half = 7.745966692414834;           ///< of the chord that the ground cuts off a circle [m]

/// A block of level ground.
const support::SolidSlope<2>& get_ground() {
  static const support::SolidSlope<2> ground({{{0, 0}, {40, 0}, {40, top}, {0, top}}, 1e4, 0, 0, 18e3, 1e7, 0.3, 0.5});
  return ground;
}

/// A circle around x, and how fast the soil above it turns: above zero its base moves to the left.
struct Turn {
  double x, speed;
};

std::vector<fem::SlipLine> find_lines(const std::vector<Turn>& turns) {
  const auto mesh = fem::make_quadratic<2>(get_ground().mesh);
  fem::SolidState<2> motion;
  motion.displacement.assign(mesh.nodes.size(), {});
  motion.strain.assign(mesh.points.size(), {});
  for (const Turn& t : turns) {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const double x = mesh.nodes[n][0] - t.x, y = mesh.nodes[n][1] - height;
      if (std::hypot(x, y) < radius) motion.displacement[n] = {t.speed * y, -t.speed * x};
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
      if (std::abs(std::hypot(mesh.points[p][0] - t.x, mesh.points[p][1] - height) - radius) < 0.5)
        motion.strain[p][3] = std::abs(t.speed);
  }
  return fem::find_slip_lines(get_ground().model, mesh, motion);
}

void expect_circle(const Line& line, double x) {
  ASSERT_GT(line.size(), 10u);
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    EXPECT_NEAR(std::hypot(line[i][0] - x, line[i][1] - height), radius, 0.35) << line[i][0] << " " << line[i][1];
  EXPECT_NEAR(std::min(line.front()[0], line.back()[0]), x - half, 0.75);
  EXPECT_NEAR(std::max(line.front()[0], line.back()[0]), x + half, 0.75);
}

TEST(SlipLines, OfOneBlockIsItsCircle) {
  const auto lines = find_lines({{20, 1}});
  ASSERT_EQ(lines.size(), 1u);
  expect_circle(lines[0].points, 20);
}

TEST(SlipLines, OfTwoBlocksAreTheirCirclesWhetherTheyMoveApartOrTogether) {
  for (const int left : {-1, 1}) {  // the way of the base of the left block
    const auto lines = find_lines({{11, -1.0 * left}, {29, 1.1 * left}});
    ASSERT_EQ(lines.size(), 2u) << left;
    EXPECT_EQ(lines[0].direction, -left) << "the faster one comes first";
    EXPECT_EQ(lines[1].direction, left);
    expect_circle(lines[0].points, 29);
    expect_circle(lines[1].points, 11);
    for (const auto& line : lines)
      EXPECT_GT(line.direction * (line.points.back()[0] - line.points.front()[0]), 0) << "runs the way of its soil";
  }
}

TEST(SlipLines, OfBlocksThatMeetUnderACrestEndAtTheirDivide) {
  const auto lines = find_lines({{20 - half, 1}, {20 + half, -1}});
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    expect_circle(line.points, 20 + line.direction * half);
    EXPECT_NEAR(line.points.front()[0], 20, 0.75);
  }
}

}  // namespace
}  // namespace talus
