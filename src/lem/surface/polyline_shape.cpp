// SPDX-License-Identifier: MIT
// Lower convex hulls and their thinning.

#include "lem/surface/polyline_shape.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

/// Twice the area of the triangle; positive where b lies below the line from a to c.
double measure_turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

Surface hang_polyline(const Slope& slope, double left, double right, const std::vector<Point>& points) {
  std::vector<Point> all{{left, slope.ground(left)}, {right, slope.ground(right)}};
  const double base = slope.section().base, gap = 1e-9 * (right - left);
  auto add = [&](const Point& p) {
    if (p[0] > left + gap && p[0] < right - gap) all.push_back({p[0], std::max(p[1], base)});
  };
  for (const Point& p : points) add(p);
  for (const Point& p : slope.section().ground) add(p);
  std::sort(all.begin(), all.end());
  Surface s;
  auto& line = s.line;
  for (const Point& p : all) {
    if (!line.empty() && p[0] - line.back()[0] < gap) continue;  // one above another: the lower one came first
    while (line.size() > 1 && measure_turn(line[line.size() - 2], line.back(), p) <= 0) line.pop_back();
    line.push_back(p);
  }
  return s;
}

std::vector<Point> thin_points(std::vector<Point> line, int count) {
  while (static_cast<int>(line.size()) > std::max(count, 2)) {
    std::size_t least = 1;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      if (measure_turn(line[i - 1], line[i], line[i + 1]) < measure_turn(line[least - 1], line[least], line[least + 1]))
        least = i;
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return line;
}

}  // namespace talus::lem
