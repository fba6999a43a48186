// SPDX-License-Identifier: MIT
#include "output/plots/true_scale.hpp"

#include <fmt/format.h>

#include <cmath>

namespace talus::output {
namespace {

constexpr double plot_width = 800, smallest_width = 60, smallest_height = 110, largest_height = 640;  ///< [px]

}  // namespace

FrameSize fit_frame(Box& box) {
  double w = plot_width, h = w * (box.y1 - box.y0) / (box.x1 - box.x0);
  if (h > largest_height) w *= largest_height / h, h = largest_height;
  if (h < smallest_height) {
    const double grow = 0.5 * (smallest_height / h - 1) * (box.y1 - box.y0);
    box.y0 -= grow, box.y1 += grow, h = smallest_height;
  }
  return {std::max(w, smallest_width), h};
}

double find_left_margin(const Box& box) {
  constexpr double margin = 75, digit = 7, usual = 4;
  const auto digits = static_cast<double>(fmt::format("{:.0f}", std::max(std::abs(box.y0), std::abs(box.y1))).size());
  return margin + digit * std::max(0.0, digits - usual);
}

std::string draw_line(const std::vector<results::Point>& points, double unit, bool close) {
  std::string rows;
  for (const auto& p : points) rows += fmt::format("{:.12g} {:.12g}\n", p[0] * unit, p[1] * unit);
  if (close && !points.empty()) rows += fmt::format("{:.12g} {:.12g}\n", points[0][0] * unit, points[0][1] * unit);
  return rows + "\n";
}

}  // namespace talus::output
