// SPDX-License-Identifier: MIT
#pragma once
// A picture of one quantity on the material points of one frame.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

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
