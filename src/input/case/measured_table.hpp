// SPDX-License-Identifier: MIT
#pragma once
// Tables of measurements of element tests.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "input/case/point_test.hpp"

namespace talus::input {

/// The quantity of an element test by its name; nullptr when there is none.
const PointQuantity* find_point_quantity(const std::string& name);

/// One `unit` of a measured quantity in SI. An empty unit is none. Throws Error (wrong_input) with one sentence when it
/// is unknown or of another dimension.
double find_measured_factor(const PointQuantity& quantity, const std::string& unit);

/// The columns `x` and `y` of a TextTable [SI], row by row; rows in which one of them is empty are left out. Throws
/// Error (wrong_input) with one sentence that names the file and the line.
std::vector<std::array<double, 2>> read_measured_table(const std::filesystem::path& path, const PointQuantity& x,
                                                       const PointQuantity& y);

}  // namespace talus::input
