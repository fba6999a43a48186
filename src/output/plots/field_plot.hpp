// SPDX-License-Identifier: MIT
#pragma once
// A picture of one quantity on the material points of one frame.

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::output {

// Pictures of a plane in which lengths are true: the part that is drawn, and the frame around it.

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

struct FieldPlot {
  std::string title;              ///< the quantity in words
  std::string subtitle;           ///< time and stage
  std::vector<double> positions;  ///< three coordinates a point [m]; drawn as seen along z
  std::vector<double> values;     ///< one a point, in `unit`; NaN is drawn grey
  std::string unit;               ///< "" or "-" for none
  std::string length_unit = "m";
  double units_per_metre = 1;  ///< of the length unit
  /// Signed quantities get a map with white at zero and equal ends; found from the values when not set.
  std::optional<bool> signed_values;
  std::optional<std::array<double, 2>> range;                    ///< ends of the colour bar, in `unit`
  std::vector<std::vector<std::array<double, 2>>> outlines;      ///< closed polygons, e.g. the soil at the start [m]
  std::vector<std::array<std::array<double, 2>, 2>> mesh_lines;  ///< sides of elements [m]
  double point_diameter = 0;                                     ///< [m]; 0: from the spacing of the points
};

/// Draws into `picture` (.svg or .png); errors as for run_gnuplot. No points is an Error (wrong_input).
void draw(const FieldPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
