// SPDX-License-Identifier: MIT
#pragma once
// Units in which results, messages and reports show quantities, derived from the three that a case names.

#include <cstddef>
#include <optional>
#include <string>

#include "base/numbers.hpp"

namespace talus {

/// Unit of display: value in SI = displayed value × si.
struct ShownUnit {
  std::string name;
  double si = 1;
};

struct ShownUnits {
  ShownUnit length{"m", 1}, displacement{"mm", 1e-3}, stress{"kPa", 1e3};
  // These depend on the unit of stress: pounds with psf.
  ShownUnit stiffness{"MPa", 1e6}, unit_weight{"kN/m³", 1e3}, line_force{"kN/m", 1e3};
  ShownUnit span{"m", 1};  ///< metre, or foot with lengths in feet or inches; for volumes, flows and speeds

  /// Returns "m²" or "ft²".
  ShownUnit area() const { return {span.name + "²", span.si * span.si}; }
  /// Returns "m³/m" or "ft³/ft" in 2D, "m³" or "ft³" in 3D.
  ShownUnit volume(std::size_t dimension) const;
  /// Returns the unit of flow, such as "m³/s/m" in 2D.
  ShownUnit flow(std::size_t dimension) const;
  ShownUnit speed() const { return {span.name + "/s", span.si}; }
  ShownUnit acceleration() const { return {span.name + "/s²", span.si}; }
  /// Returns the unit of rain, "mm/h" or "in/h".
  ShownUnit rain() const;
};

/// Derives the units of a case from the names of its three. Throws Error (wrong_input) for an unknown unit.
ShownUnits make_shown_units(const std::string& length, const std::string& displacement, const std::string& stress);

/// Formats a value [SI] for a message, with `digits` significant digits: "3.28 ft".
std::string format_value(double si, const ShownUnit& unit, int digits = 6);

/// Formats a value with its uncertainty [SI], rounded to the digits of the latter: "1.3 ± 0.4 m". Without an
/// uncertainty it has two digits.
std::string format_uncertain(double si, std::optional<double> uncertainty, const ShownUnit& unit);

/// Formats a coordinate [m] with all its digits: "12.345 m".
inline std::string format_coordinate(double x, const ShownUnit& unit) {
  return format_coordinate(x / unit.si) + " " + unit.name;
}

/// Formats two or three coordinates [m] without the name of the unit: "(12.345, 4000012.5)".
std::string format_point(auto point, const ShownUnit& unit) {
  for (double& x : point) x /= unit.si;
  return format_point(point);
}

/// Formats two or three coordinates [m] with four digits: "(12.35, 4.5) m".
std::string format_place(const auto& point, const ShownUnit& unit) {
  std::string text;
  for (const double x : point) text += (text.empty() ? "(" : ", ") + format_significant(x / unit.si, 4);
  return text + ") " + unit.name;
}

}  // namespace talus
