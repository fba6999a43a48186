// SPDX-License-Identifier: MIT
#pragma once
// Plots of curves: displacement over strength reduction factor with its constructions, and the curves of a study.

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

/// A factor of safety, with its bracket if there is one.
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
  std::optional<double> intersection;            ///< SRF at their intersection [-]
  std::vector<FactorMark> criteria;
  std::vector<PlotSeries> references;  ///< published values [m]
  std::string displacement_unit = "mm";
  double units_per_metre = 1000;  ///< units of displacement per metre
  bool log_displacement = false;
};

/// Several curves with a legend, for studies.
struct TablePlot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  bool log_x = false, log_y = false;
  bool is_history = false;  ///< many rows: both axes start at zero, symbols at every twelfth point
};

/// Draw `picture` (.svg or .png); errors as for run_gnuplot(). A curve without points is an Error (wrong_input).
void draw(const CurvePlot& plot, const std::filesystem::path& picture);
void draw(const TablePlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
