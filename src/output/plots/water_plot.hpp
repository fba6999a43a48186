// SPDX-License-Identifier: MIT
#pragma once
// Picture of soil-water curves: degree of saturation and conductivity over suction, a row of two panels per soil.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::output {

// The hydraulic laws of a soil as numbers over suction: for the picture of water_plot.hpp and for a table.

/// The curves of one soil at the suctions `suction`, with what a reader needs to check them. SI units.
struct WaterCurves {
  std::string material;
  std::string retention;                                ///< name of the law and its parameters, in engineering units
  std::string conductivity;                             ///< the same of the conductivity
  std::vector<double> suction;                          ///< [Pa], increasing, logarithmically even
  std::vector<double> saturation, slope;                ///< S [-], dS/ds [1/Pa]
  std::vector<double> chi;                              ///< Bishop's χ [-]; empty where χ = S
  std::vector<double> relative;                         ///< k_r [-]
  double saturated_conductivity = 0;                    ///< k of the saturated soil [m/s]
  std::vector<std::array<double, 2>> saturation_pairs;  ///< of a table: suction [Pa], S [-]
  std::vector<std::array<double, 2>> relative_pairs;    ///< of a table: suction [Pa], k_r [-]
  std::optional<double> air_entry;                      ///< of Mualem's k_r [Pa]
};

/// The curves of all wet materials of a case, in the order of their names, over one range of suction: whole decades
/// within 0.01 kPa to 10 MPa (and what tables hold beyond), without those at either end in which no curve changes, but
/// two at least. Empty for a dry case.
std::vector<WaterCurves> sample_water_curves(const input::Case& data);

/// The curves as comma-separated text, one row per material and suction: `material,suction [kPa],saturation [-],...`.
std::string make_water_table(const std::vector<WaterCurves>& soils);

struct WaterPlot {
  std::string title;
  std::vector<WaterCurves> soils;  ///< over one range of suction
};

/// Draws into `picture` (.svg or .png); errors as for run_gnuplot. No soil is an Error (wrong_input).
void draw(const WaterPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
