// SPDX-License-Identifier: MIT
#pragma once
// Numbers in sentences, in the units that a report shows.

#include <nlohmann/json_fwd.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::report {

inline constexpr double degree = std::numbers::pi / 180;  ///< [rad]

/// A unit of display: value in SI = value shown × si.
struct ShownUnit {
  std::string name;
  double si = 1;
};
nlohmann::json to_json(const ShownUnit& unit);
struct ShownUnits {
  ShownUnit length{"m", 1}, displacement{"mm", 1e-3}, stress{"kPa", 1e3};
  // They go with the stress: pounds with psf.
  ShownUnit stiffness{"MPa", 1e6}, unit_weight{"kN/m³", 1e3}, line_force{"kN/m", 1e3};
  ShownUnit span{"m", 1};  ///< metres, or feet beside lengths in feet or inches: of volumes, flows, and speeds

  /// "m³/m", "ft³/ft" in the plane; "m³" in space.
  ShownUnit volume(std::size_t dimension) const;
  /// "m³/s/m".
  ShownUnit flow(std::size_t dimension) const;
  ShownUnit speed() const { return {span.name + "/s", span.si}; }
  ShownUnit acceleration() const { return {span.name + "/s²", span.si}; }
  /// Of rain: "mm/h" or "in/h".
  ShownUnit rain() const;
};
ShownUnits read_units(const results::RunResult& run);
/// "3.23", "−0.061", "4.06 × 10⁻⁶": `digits` significant digits, and all before the point; "–" for a value that is
/// not finite.
std::string show_number(double value, int digits = 3);
/// "3.23 m".
std::string show(double si, const ShownUnit& unit, int digits = 3);
/// "2.54 m³ per metre": a volume or flow of one metre or foot of the plane, for sentences.
std::string show_per_thickness(double si, const ShownUnit& unit, int digits = 3);
/// The same unit in words: "m³ per metre".
ShownUnit name_thickness(ShownUnit unit);
/// "1.3 ± 0.4 m", with the digits that the uncertainty [SI] leaves; two digits where it is not known.
std::string show_uncertain(double si, std::optional<double> uncertainty, const ShownUnit& unit);
/// A coordinate with all its digits: "4000012.5 m".
std::string show_coordinate(double si, const ShownUnit& unit);
/// The largest unit of time that the duration [s] has two of.
ShownUnit choose_time_unit(double duration);
/// 0 for a value that is not finite.
double keep_finite(double value);
/// "a, b and c".
std::string join_words(const std::vector<std::string>& words);

}  // namespace talus::report
