// SPDX-License-Identifier: MIT
#pragma once
// Format of numbers in sentences, in the units of display of the case.

#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::report {

inline constexpr double degree = std::numbers::pi / 180;  ///< π/180 [rad]

/// Unit of display: value in SI = displayed value × si.
struct ShownUnit {
  std::string name;
  double si = 1;
};
nlohmann::json to_json(const ShownUnit& unit);
struct ShownUnits {
  ShownUnit length{"m", 1}, displacement{"mm", 1e-3}, stress{"kPa", 1e3};
  // These depend on the unit of stress: pounds with psf.
  ShownUnit stiffness{"MPa", 1e6}, unit_weight{"kN/m³", 1e3}, line_force{"kN/m", 1e3};
  ShownUnit span{"m", 1};  ///< metre, or foot with lengths in feet or inches; for volumes, flows and speeds

  /// Returns "m³/m" or "ft³/ft" in 2D, "m³" or "ft³" in 3D.
  ShownUnit volume(std::size_t dimension) const;
  /// Returns the unit of flow, such as "m³/s/m" in 2D.
  ShownUnit flow(std::size_t dimension) const;
  ShownUnit speed() const { return {span.name + "/s", span.si}; }
  ShownUnit acceleration() const { return {span.name + "/s²", span.si}; }
  /// Returns the unit of rain, "mm/h" or "in/h".
  ShownUnit rain() const;
};
ShownUnits read_units(const results::RunResult& run);
/// Formats with `digits` significant digits, and with all digits of the integer part: "3.23", "−0.061", "4.06 × 10⁻⁶".
/// Returns "–" for a non-finite value.
std::string show_number(double value, int digits = 3);
/// Formats a value with its unit: "3.23 m".
std::string show(double si, const ShownUnit& unit, int digits = 3);
/// Formats a volume or flow per unit thickness for a sentence: "2.54 m³ per metre".
std::string show_per_thickness(double si, const ShownUnit& unit, int digits = 3);
/// Returns the unit with its thickness in words: "m³ per metre".
ShownUnit name_thickness(ShownUnit unit);
/// Formats a value with its uncertainty [SI], rounded to the digits of the latter: "1.3 ± 0.4 m". Without an
/// uncertainty it has two digits.
std::string show_uncertain(double si, std::optional<double> uncertainty, const ShownUnit& unit);
/// Formats a coordinate with all its digits: "4000012.5 m".
std::string show_coordinate(double si, const ShownUnit& unit);
/// Returns the largest unit of time of which the duration [s] has at least two.
ShownUnit choose_time_unit(double duration);
/// Returns 0 for a non-finite value.
double keep_finite(double value);
/// Joins words as "a, b and c".
std::string join_words(const std::vector<std::string>& words);

}  // namespace talus::report
