// SPDX-License-Identifier: MIT
// Sections: means over the points beside a line.

#include <gtest/gtest.h>

#include <cmath>

#include "run/mpm/record/sections.hpp"

namespace talus::run {
namespace {

/// Points on a grid of 0.1 m over 2 m × 2 m with a field that is linear in the place, and a vector of it.
output::Frame make_grid(double y_end = 2) {
  output::Frame frame;
  output::Field volume{"volume", "m3", 1, {}}, linear{"pore_pressure", "Pa", 1, {}}, vector{"velocity", "m/s", 3, {}};
  for (double x = 0.05; x < 2; x += 0.1)
    for (double y = 0.05; y < y_end; y += 0.1) {
      frame.positions.insert(frame.positions.end(), {x, y, 0});
      frame.ids.push_back(static_cast<int>(frame.ids.size()));
      frame.materials.push_back(0);
      volume.values.push_back(x < 1 ? 0.01 : 0.03);
      linear.values.push_back(5 + 2 * y);
      vector.values.insert(vector.values.end(), {y, -y, 0});
    }
  frame.point_fields = {volume, linear, vector};
  return frame;
}

TEST(Section, OfALinearFieldIsThatField) {
  const output::Frame frame = make_grid();
  const input::SectionLine vertical{"A", {1, 0, 0}, {1, 2, 0}, {}};
  const auto columns = list_section_columns(frame, 2);
  ASSERT_EQ(columns.size(), 4u);  // volume, pressure, two components of the velocity
  EXPECT_EQ(columns[3].name, "velocity_y");
  const auto rows = cut_section(frame, vertical, 2, 0.4);
  ASSERT_EQ(rows.size(), 5u);
  for (const SectionRow& row : rows) {
    EXPECT_EQ(row.points, 16) << "four across, four along";
    EXPECT_NEAR(row.values[1], 5 + 2 * row.distance, 1e-12);
    EXPECT_NEAR(row.values[3], -row.distance, 1e-12);
    EXPECT_NEAR(row.position[1], row.distance, 1e-12);
  }
}

TEST(Section, WeighsPointsByTheirVolume) {
  output::Frame frame = make_grid();
  frame.point_fields[1].values.clear();
  for (std::size_t i = 0; i < frame.ids.size(); ++i)
    frame.point_fields[1].values.push_back(frame.positions[3 * i] < 1 ? 0 : 4);
  const auto rows = cut_section(frame, {"A", {1, 0, 0}, {1, 2, 0}, {}}, 2, 0.4);
  EXPECT_NEAR(rows[0].values[1], 3, 1e-12) << "three quarters of the volume have 4";
}

TEST(Section, ReversedOrObliqueItReadsTheSamePlaces) {
  const output::Frame frame = make_grid();
  const auto down = cut_section(frame, {"A", {1, 2, 0}, {1, 0, 0}, {}}, 2, 0.4);
  EXPECT_NEAR(down[0].values[1], 5 + 2 * (2 - down[0].distance), 1e-12);
  for (const SectionRow& row : cut_section(frame, {"A", {0, 0, 0}, {2, 2, 0}, {}}, 2, 0.3))
    EXPECT_NEAR(row.values[1], 5 + 2 * row.position[1], 0.05) << "points lie a little more on one side";
}

TEST(Section, LeavesOutWhatIsNotThere) {
  output::Frame frame = make_grid(1);
  for (std::size_t i = 0; i < frame.ids.size(); ++i)
    if (frame.positions[3 * i + 1] < 0.4) frame.point_fields[1].values[i] = NAN;
  const auto rows = cut_section(frame, {"A", {1, 0, 0}, {1, 2, 0}, {}}, 2, 0.4);
  ASSERT_EQ(rows.size(), 3u) << "no row where there is no soil";
  EXPECT_TRUE(std::isnan(rows[0].values[1]));
  EXPECT_TRUE(std::isfinite(rows[0].values[3])) << "the other fields are there";
}

}  // namespace
}  // namespace talus::run
