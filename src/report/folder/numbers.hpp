// SPDX-License-Identifier: MIT
#pragma once
// Format of numbers in sentences, in the units of display of the case.

#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "results/run.hpp"

namespace talus::report {

inline constexpr double degree = std::numbers::pi / 180;  ///< π/180 [rad]

nlohmann::json to_json(const ShownUnit& unit);
/// Formats with `digits` significant digits, and with all digits of the integer part: "3.23", "−0.061", "4.06 × 10⁻⁶".
/// Returns "–" for a non-finite value.
std::string show_number(double value, int digits = 3);
/// Formats a value with its unit: "3.23 m".
std::string show(double si, const ShownUnit& unit, int digits = 3);
/// Formats a volume or flow per unit thickness for a sentence: "2.54 m³ per metre".
std::string show_per_thickness(double si, const ShownUnit& unit, int digits = 3);
/// Returns the unit with its thickness in words: "m³ per metre".
ShownUnit name_thickness(ShownUnit unit);
/// Formats a coordinate with all its digits: "4000012.5 m".
std::string show_coordinate(double si, const ShownUnit& unit);
/// Returns the largest unit of time of which the duration [s] has at least two.
ShownUnit choose_time_unit(double duration);
/// Returns 0 for a non-finite value.
double keep_finite(double value);
/// Joins words as "a, b and c".
std::string join_words(const std::vector<std::string>& words);

}  // namespace talus::report
