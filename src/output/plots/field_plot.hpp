// SPDX-License-Identifier: MIT
#pragma once
// Plot of one quantity at the material points of a frame; and the box and frame of plots that are true to scale.

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
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
  void widen(double by) { x0 -= by, y0 -= by, x1 += by, y1 += by; }
};

/// Size of the frame [px].
struct FrameSize {
  double width = 0, height = 0;
};

/// Returns the frame with the aspect ratio of `box`; a very flat box is made higher.
FrameSize fit_frame(Box& box);

/// Returns the width [px] left of the frame for the tic labels and title of the vertical axis.
double find_left_margin(const Box& box);

/// Returns the lines of a data block for one polyline, with an empty line at the end; `close` repeats the first point.
std::string draw_line(const std::vector<results::Point>& points, double unit, bool close);

struct FieldPlot {
  std::string title;              ///< the quantity in words
  std::string subtitle;           ///< time and stage
  std::vector<double> positions;  ///< three coordinates per point [m]; the view is along z
  std::vector<double> values;     ///< one per point, in `unit`; NaN is drawn grey
  std::string unit;               ///< "" or "-" if dimensionless
  std::string length_unit = "m";
  double units_per_metre = 1;  ///< length units per metre
  /// Signed quantities have a colour map with white at zero and symmetric limits; determined from the values if not
  /// set.
  std::optional<bool> signed_values;
  std::optional<std::array<double, 2>> range;                    ///< limits of the colour bar, in `unit`
  std::vector<std::vector<std::array<double, 2>>> outlines;      ///< closed polygons, such as initial soils [m]
  std::vector<std::array<std::array<double, 2>, 2>> mesh_lines;  ///< sides of elements [m]
  double point_diameter = 0;                                     ///< [m]; 0: estimated from the spacing of the points
};

/// Draws `picture` (.svg or .png); errors as for run_gnuplot(). Throws Error (wrong_input) if there are no points.
void draw(const FieldPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
