// SPDX-License-Identifier: MIT
#pragma once
// `talus plot CASE`: the soil-water curves of a case.

#include <filesystem>
#include <string>

#include "app/case_options.hpp"

namespace talus::app {

/// Draws the curves of every soil with pore water into `picture`, and writes their numbers beside it as .csv. By
/// default the picture is the case's name with _soil_water, in the current folder, in `format` ("svg", "png"). Prints
/// both names. Throws Error (wrong_input) for a case without pore water.
void plot_soil_water(const CaseOptions& input, const std::filesystem::path& picture, const std::string& format);

}  // namespace talus::app
