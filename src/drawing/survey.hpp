// SPDX-License-Identifier: MIT
#pragma once
// The section of a survey: tables of lines and of boreholes.

#include <optional>
#include <string>
#include <vector>

#include "drawing/section.hpp"

namespace talus::drawing {

struct SurveyOptions {
  double unit = 1;             ///< of lengths in columns without a unit [m]
  bool is_unit_given = false;  ///< by the user; otherwise a remark names it where it is used
  std::optional<double> base;  ///< level of the base of the section [m]
  /// Boreholes to use; empty: all.
  std::vector<std::string> boreholes;
};

/// Reads the section of tables. The first table of lines is the ground, the others are lower boundaries from the top
/// down, with the names of their files; without one, the ground is a line through the tops of the boreholes. Positions
/// in plan become distances along the line that fits them best. Rows that are not understood are remarks, and so are
/// boreholes with such rows. Throws Error (wrong_input) if there is no section.
DrawnSection read_survey(const std::vector<std::string>& files, const SurveyOptions& options);

}  // namespace talus::drawing
