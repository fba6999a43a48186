// SPDX-License-Identifier: MIT
// Where the ends of trial circles stand on the ground.

#include <algorithm>
#include <cmath>

#include "lem/search/random_parts.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

namespace {

/// Points per metre that a place deserves: as many on every slope, whatever its size, and fewer with the distance to
/// it.
class Density {
 public:
  explicit Density(const Slope& slope) {
    const auto& ground = slope.section().ground;
    double highest = ground.front()[1], lowest = highest;
    for (const Point& p : ground) highest = std::max(highest, p[1]), lowest = std::min(lowest, p[1]);
    for (std::size_t i = 1; i < ground.size(); ++i) {
      const double height = std::abs(ground[i][1] - ground[i - 1][1]);
      // A kerb deserves some points, not as many as the slope that it stands on.
      if (height > 1e-6 * (highest - lowest))
        faces_.push_back({ground[i - 1][0], ground[i][0], height, std::sqrt(height / (highest - lowest))});
    }
    floor_ = 2 / (slope.right() - slope.left());
  }
  double operator()(double x) const {
    double density = floor_;
    for (const Face& f : faces_) {
      const double distance = std::max({f.from - x, x - f.to, 0.0});
      density = std::max(density, f.weight / (distance + 0.5 * f.height));
    }
    return density;
  }

 private:
  struct Face {
    double from, to, height, weight;
  };
  std::vector<Face> faces_;
  double floor_ = 0;
};

}  // namespace

std::vector<double> place_points(const Slope& slope, double from, double to, int count, int seed) {
  from = std::max(from, slope.left());
  to = std::min(to, slope.right());
  if (!(to > from) || count < 2) return {from};
  const Density density(slope);
  constexpr int cells = 4000;
  const double width = (to - from) / cells;
  std::vector<double> sum(cells + 1, 0.0);
  for (std::size_t i = 0; i < cells; ++i)
    sum[i + 1] = sum[i] + density(from + (static_cast<double>(i) + 0.5) * width) * width;
  std::vector<double> points{from};
  RandomParts parts(seed);
  std::size_t cell = 0;
  for (int i = 1; i + 1 < count; ++i) {
    // A random start moves each by less than half a spacing, so that they keep their order.
    const double target = sum.back() * (i + (seed > 0 ? 0.49 * parts.draw() : 0)) / (count - 1);
    while (sum[cell + 1] < target) ++cell;
    points.push_back(from + width * (static_cast<double>(cell) + (target - sum[cell]) / (sum[cell + 1] - sum[cell])));
  }
  points.push_back(to);
  // Circles often end in a corner of the ground: the nearest point, if still free, moves there; the nearest pair first.
  std::vector<std::array<double, 2>> corners;  // distance to the nearest point, x
  for (const Point& corner : slope.section().ground) {
    const double x = corner[0];
    if (x <= from || x >= to) continue;
    const auto right = std::upper_bound(points.begin(), points.end(), x);
    corners.push_back({std::min(x - *(right - 1), *right - x), x});
  }
  std::stable_sort(corners.begin(), corners.end(), [](auto& a, auto& b) { return a[0] < b[0]; });
  std::vector<char> taken(points.size(), 0);
  taken.front() = taken.back() = 1;
  for (const auto& [distance, x] : corners) {
    const auto right = std::upper_bound(points.begin(), points.end(), x);
    const auto nearest = x - *(right - 1) < *right - x ? right - 1 : right;
    auto& used = taken[static_cast<std::size_t>(nearest - points.begin())];
    if (!used) *nearest = x, used = 1;
  }
  return points;
}

}  // namespace talus::lem
