// SPDX-License-Identifier: MIT
// Finds the pore pressure at a place in a grid of triangles.

#include "lem/section/pressure_locator.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

struct Box {
  Point low{}, high{};
};

Box bound(const PressureGrid& grid, const std::array<int, 3>& triangle) {
  const Point& first = grid.nodes[static_cast<std::size_t>(triangle[0])];
  Box box{first, first};
  for (const int node : triangle)
    for (std::size_t d = 0; d < 2; ++d) {
      const double value = grid.nodes[static_cast<std::size_t>(node)][d];
      box.low[d] = std::min(box.low[d], value);
      box.high[d] = std::max(box.high[d], value);
    }
  return box;
}

}  // namespace

PressureLocator::PressureLocator(const PressureGrid& grid) {
  if (grid.triangles.empty()) return;
  std::vector<Box> boxes;
  for (const auto& triangle : grid.triangles) boxes.push_back(bound(grid, triangle));
  Point high = boxes[0].high;
  low_ = boxes[0].low;
  for (const Box& box : boxes)
    for (std::size_t d = 0; d < 2; ++d) {
      low_[d] = std::min(low_[d], box.low[d]);
      high[d] = std::max(high[d], box.high[d]);
    }
  const double width = std::max(high[0] - low_[0], 1e-12), height = std::max(high[1] - low_[1], 1e-12);
  const double count = static_cast<double>(boxes.size());
  size_ = std::max(std::sqrt(width * height / count), std::max(width, height) / 4000);
  columns_ = static_cast<int>(width / size_) + 1;
  rows_ = static_cast<int>(height / size_) + 1;
  std::vector<std::vector<int>> buckets(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    const auto step = [&](double v, std::size_t d) { return static_cast<int>((v - low_[d]) / size_); };
    for (int j = step(boxes[t].low[1], 1); j <= std::min(step(boxes[t].high[1], 1), rows_ - 1); ++j)
      for (int i = step(boxes[t].low[0], 0); i <= std::min(step(boxes[t].high[0], 0), columns_ - 1); ++i)
        buckets[find_bucket(i, j)].push_back(static_cast<int>(t));
  }
  first_.push_back(0);
  for (const auto& bucket : buckets) {
    for (const int t : bucket) {
      const auto& corner = grid.triangles[static_cast<std::size_t>(t)];
      const auto node = [&](std::size_t i) { return grid.nodes[static_cast<std::size_t>(corner[i])]; };
      const auto u = [&](std::size_t i) { return grid.pressure[static_cast<std::size_t>(corner[i])]; };
      const Point a = node(0), b = node(1), c = node(2);
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      if (area == 0) continue;
      planes_.push_back({a,
                         {(c[1] - a[1]) / area, (a[0] - c[0]) / area},
                         {(a[1] - b[1]) / area, (b[0] - a[0]) / area},
                         u(0),
                         u(1) - u(0),
                         u(2) - u(0)});
    }
    first_.push_back(static_cast<int>(planes_.size()));
  }
}

std::optional<double> PressureLocator::find(const Point& p) const {
  if (empty()) return std::nullopt;
  // A hair outside counts as inside, so that the border of the model is not lost to rounding.
  const double x = (p[0] - low_[0]) / size_, y = (p[1] - low_[1]) / size_;
  if (!(x >= -1e-9 && y >= -1e-9 && x <= columns_ + 1e-9 && y <= rows_ + 1e-9)) return std::nullopt;
  const int i = std::clamp(static_cast<int>(x), 0, columns_ - 1), j = std::clamp(static_cast<int>(y), 0, rows_ - 1);
  const auto bucket = find_bucket(i, j);
  for (int k = first_[bucket]; k < first_[bucket + 1]; ++k)
    if (const auto u = read(planes_[static_cast<std::size_t>(k)], p)) return u;
  return std::nullopt;
}

std::optional<double> PressureLocator::read(const Plane& plane, const Point& p) {
  const double dx = p[0] - plane.corner[0], dy = p[1] - plane.corner[1];
  const double second = plane.second[0] * dx + plane.second[1] * dy;
  const double third = plane.third[0] * dx + plane.third[1] * dy;
  constexpr double hair = -1e-7;
  if (second < hair || third < hair || 1 - second - third < hair) return std::nullopt;
  return plane.pressure + second * plane.to_second + third * plane.to_third;
}

}  // namespace talus::lem
