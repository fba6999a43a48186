// SPDX-License-Identifier: MIT
#pragma once
// A picture of a section: its soils, the water table and ponds, and the slip surfaces that the methods found.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/comparison.hpp"
#include "results/water.hpp"

namespace talus::output {

struct SectionPlot {
  std::string title;
  std::vector<std::vector<results::Point>> outlines;  ///< of the soils, closed polygons [m]
  std::vector<results::MethodSurface> surfaces;
  std::string length_unit = "m";
  std::optional<results::WaterState> water;  ///< that the methods began with
};

/// Draws into `picture` (.svg or .png) true to scale, with a legend of the surfaces and their factors below; bands of
/// finite elements are wide and pale. Errors as for run_gnuplot. No surface is an Error (wrong_input).
void draw(const SectionPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
