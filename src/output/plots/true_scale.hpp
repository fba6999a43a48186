// SPDX-License-Identifier: MIT
#pragma once
// Pictures of a plane in which lengths are true: the part that is drawn, and the frame around it.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::output {

struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void include(double x, double y) {
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  /// Moves all sides outwards.
  void widen(double by) { x0 -= by, y0 -= by, x1 += by, y1 += by; }
};

/// Width and height [px] of the frame.
struct FrameSize {
  double width = 0, height = 0;
};

/// The frame that has exactly the shape of `box`; a very flat box is made higher.
FrameSize fit_frame(Box& box);

/// Width [px] left of the frame, where its heights and their title stand.
double find_left_margin(const Box& box);

/// The lines of a data block for one line of points, with an empty line at the end; `close` returns to the first point.
std::string draw_line(const std::vector<results::Point>& points, double unit, bool close);

}  // namespace talus::output
