// SPDX-License-Identifier: MIT
// Trial circles about a grid of centres, with radii between two elevations of their deepest points.

#include <algorithm>
#include <cmath>

#include "lem/search/trial_circles.hpp"

namespace talus::lem {

namespace {

/// Centres over the slopes, as high again as the slopes are wide; deepest points from the base to the crest.
void choose_grid(const Slope& slope, bool named, GridSearch& grid) {
  const auto& ground = slope.section().ground;
  double low = ground.front()[1], high = low, left = slope.right(), right = slope.left(), widest = 0, from = 0;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    low = std::min(low, ground[i][1]), high = std::max(high, ground[i][1]);
    if (i == 0 || ground[i][1] == ground[i - 1][1]) continue;
    const bool same = i > 1 && (ground[i][1] - ground[i - 1][1]) * (ground[i - 1][1] - ground[i - 2][1]) > 0;
    from = same ? from : ground[i - 1][0];
    widest = std::max(widest, ground[i][0] - from);
    left = std::min(left, ground[i - 1][0]), right = std::max(right, ground[i][0]);
  }
  if (!(right > left)) left = slope.left(), right = slope.right();
  const double height = high - low;
  if (!named) {
    grid.from = {left, high + 0.05 * height};
    grid.to = {right, high + std::max(1.5 * height, 1.5 * widest)};
  }
  if (!grid.lowest) grid.lowest = std::max(slope.section().base, low - 1.5 * height);
  if (!grid.highest) grid.highest = high - 0.05 * height;
}

}  // namespace

TrialCircles make_grid_circles(const Slope& slope, const std::optional<GridSearch>& asked, GridSearch& used) {
  used = asked.value_or(GridSearch{});
  choose_grid(slope, used.from != used.to, used);
  TrialCircles circles;
  circles.whole_ground = true;
  circles.left = circles.right = {slope.left(), slope.right()};
  circles.size = {used.columns, used.rows, used.radii};
  auto between = [](double a, double b, int i, int n) { return n > 1 ? a + (b - a) * i / (n - 1) : 0.5 * (a + b); };
  for (int i = 0; i < used.columns; ++i)
    for (int j = 0; j < used.rows; ++j)
      for (int k = 0; k < used.radii; ++k) {
        circles.first.push_back(static_cast<int>(circles.surfaces.size()));
        const Point centre{between(used.from[0], used.to[0], i, used.columns),
                           between(used.from[1], used.to[1], j, used.rows)};
        // From deep to shallow, as the depths of the other search grow; a hair above the base, which they may touch.
        const double bottom = between(*used.highest, *used.lowest, k, used.radii), radius = centre[1] - bottom;
        if (!(radius > 0)) continue;
        const Circle circle{centre, radius * (1 - 1e-9)};
        for (const auto& [left, right] : find_arcs(slope, circle)) {
          Surface s;
          s.circle = circle;
          s.from = left, s.to = right;
          circles.surfaces.push_back(s);
        }
      }
  circles.first.push_back(static_cast<int>(circles.surfaces.size()));
  const double step = 0.03 * (slope.right() - slope.left());
  circles.step = {step, step};
  return circles;
}

}  // namespace talus::lem
