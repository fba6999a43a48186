// SPDX-License-Identifier: MIT
#pragma once
// Plot of element tests: several diagrams of the same tests, with one legend.

#include <filesystem>
#include <string>
#include <vector>

namespace talus::output {

struct PointLine {
  std::string label;
  int colour = 0, dash = 0;  ///< indices from 0
};

struct PointDiagram {
  std::string x_label, y_label;
  bool log_x = false;
  std::vector<std::vector<double>> x, y;  ///< by line
};

struct PointPlot {
  std::string title;
  std::vector<PointLine> lines;
  std::vector<PointDiagram> diagrams;  ///< two per row
};

/// Draws `picture` (.svg or .png); errors as for run_gnuplot(). Throws Error (wrong_input) if there are no lines.
void draw(const PointPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
