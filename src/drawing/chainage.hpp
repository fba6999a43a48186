// SPDX-License-Identifier: MIT
#pragma once
// The chainage of a survey beside coordinates in plan.

#include <string>
#include <vector>

#include "drawing/survey_table.hpp"

namespace talus::drawing {

/// Compares the chainage of a table with its coordinates, which may be those of a map projection, of a web map
/// (EPSG:3857) or longitudes and latitudes. Returns a remark with both lengths; empty for a table without both. Rows of
/// boreholes that are not among `boreholes` are left out, unless it is empty. Throws Error (wrong_input) with both
/// lengths if they differ by more than 1 %.
std::string compare_chainage(const SurveyTable& table, const std::vector<std::string>& boreholes);

}  // namespace talus::drawing
