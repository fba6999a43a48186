// SPDX-License-Identifier: MIT
#pragma once
// Picture of soil-water curves: degree of saturation and conductivity over suction, a row of two panels per soil.

#include <filesystem>
#include <string>
#include <vector>

#include "output/plots/water_curves.hpp"

namespace talus::output {

struct WaterPlot {
  std::string title;
  std::vector<WaterCurves> soils;  ///< over one range of suction
};

/// Draws into `picture` (.svg or .png); errors as for run_gnuplot. No soil is an Error (wrong_input).
void draw(const WaterPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
