// SPDX-License-Identifier: MIT
#include "input/case/soil_outline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/numbers.hpp"

namespace talus::input {

SoilOutline::SoilOutline(const mesh::Plan& plan) : plan_(plan) {
  for (const mesh::Polygon& polygon : plan.polygons) {
    for (const auto& p : polygon.points) {
      left_ = std::min(left_, p[0]);
      right_ = std::max(right_, p[0]);
      bottom_ = std::min(bottom_, p[1]);
      top_ = std::max(top_, p[1]);
    }
  }
}

std::string SoilOutline::write_span() const {
  return fmt::format("which goes from x = {} m to x = {} m", format_coordinate(left_), format_coordinate(right_));
}

double SoilOutline::find_ground(double x) const {
  if (spans(x)) x = std::clamp(x, left_, right_);
  double level = -far_;
  for (const mesh::Polygon& polygon : plan_.polygons) {
    const auto& p = polygon.points;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto &a = p[i], &b = p[(i + 1) % p.size()];
      if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
      const double share = a[0] == b[0] ? 0 : (x - a[0]) / (b[0] - a[0]);
      level = std::max(level, a[0] == b[0] ? std::max(a[1], b[1]) : a[1] + share * (b[1] - a[1]));
    }
  }
  return level;
}

}  // namespace talus::input
