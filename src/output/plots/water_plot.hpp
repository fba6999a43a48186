// SPDX-License-Identifier: MIT
#pragma once
// Soil-water curves, degree of saturation and conductivity over suction: sampled, as a table, and as a plot with a row
// of two panels per soil.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::output {

/// Curves of one soil at the values of `suction`, with their parameters. SI units.
struct WaterCurves {
  std::string material;
  std::string retention;                                ///< name and parameters of the law, in `units`
  std::string conductivity;                             ///< name and parameters of the law, in `units`
  std::vector<double> suction;                          ///< [Pa], increasing, equally spaced in log s
  std::vector<double> saturation, slope;                ///< S [-], dS/ds [1/Pa]
  std::vector<double> chi;                              ///< Bishop's χ [-]; empty if χ = S
  std::vector<double> relative;                         ///< k_r [-]
  double saturated_conductivity = 0;                    ///< saturated conductivity [m/s]
  std::vector<std::array<double, 2>> saturation_pairs;  ///< given pairs: suction [Pa], S [-]
  std::vector<std::array<double, 2>> relative_pairs;    ///< given pairs: suction [Pa], k_r [-]
  std::optional<double> air_entry;                      ///< air entry suction in Mualem's k_r [Pa]
  ShownUnits units;                                     ///< of texts, table and plot; the same for all soils
};

/// Returns the curves of all wet materials of a case, by name, over a common range of suction: whole decades within
/// 0.01 kPa to 10 MPa (and the range of given pairs beyond), without those at the ends in which no curve changes, but
/// at least two. Returns an empty list for a dry case.
std::vector<WaterCurves> sample_water_curves(const input::Case& data);

/// Returns the curves as comma-separated text with one row per material and suction, in the units of display:
/// `material,suction [kPa],saturation [-],...`.
std::string make_water_table(const std::vector<WaterCurves>& soils);

struct WaterPlot {
  std::string title;
  std::vector<WaterCurves> soils;  ///< with a common range of suction
};

/// Draws `picture` (.svg or .png); errors as for run_gnuplot(). Throws Error (wrong_input) if there are no soils.
void draw(const WaterPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
