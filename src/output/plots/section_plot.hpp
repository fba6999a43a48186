// SPDX-License-Identifier: MIT
#pragma once
// Plot of a section: soils, water table and ponds, and the slip surfaces of the methods.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/comparison.hpp"
#include "results/water.hpp"

namespace talus::output {

struct SectionPlot {
  std::string title;
  std::vector<std::vector<results::Point>> outlines;  ///< polygons of the soils [m]
  std::vector<results::MethodSurface> surfaces;
  std::string length_unit = "m";
  std::optional<results::WaterState> water;  ///< initial state of the methods
};

/// Draws `picture` (.svg or .png) true to scale, with a legend of the surfaces and their factors below; shear bands of
/// FEM are wide and translucent. Errors as for run_gnuplot(). Throws Error (wrong_input) if there are no surfaces.
void draw(const SectionPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
