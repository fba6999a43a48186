// SPDX-License-Identifier: MIT
#pragma once
// Pictures of curves: the displacement–SRF curve with the constructions on it, and the curves of a study.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/trial.hpp"

namespace talus::output {

struct PlotSeries {
  std::string label;
  std::vector<double> x, y;
};

/// A factor of safety, with the bracket that holds it where there is one.
struct FactorMark {
  std::string name;
  double factor = 0;
  std::optional<double> lower, upper;
};

/// Displacement over strength reduction factor.
struct CurvePlot {
  std::string title;
  std::vector<double> factors;                   ///< [-], increasing
  std::vector<double> displacements;             ///< [m]
  std::optional<results::Branch> first, second;  ///< the two lines of the bilinear construction
  std::optional<double> intersection;            ///< their factor [-]
  std::vector<FactorMark> criteria;
  std::vector<PlotSeries> references;  ///< published values [m]
  std::string displacement_unit = "mm";
  double units_per_metre = 1000;  ///< of the displacement's unit
  bool log_displacement = false;
};

/// Several curves with a legend, for studies.
struct TablePlot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  bool log_x = false, log_y = false;
  bool is_history = false;  ///< many rows from zero on: a symbol for every twelfth of a curve, and both axes from zero
};

/// Draw into `picture` (.svg or .png); errors as for run_gnuplot. A curve without points is an Error (wrong_input).
void draw(const CurvePlot& plot, const std::filesystem::path& picture);
void draw(const TablePlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
