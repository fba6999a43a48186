// SPDX-License-Identifier: MIT
#pragma once
// Picture of element tests: several diagrams of the same tests, with one legend.

#include <filesystem>
#include <string>
#include <vector>

namespace talus::output {

struct PointLine {
  std::string label;
  int colour = 0, dash = 0;  ///< from 0
};

struct PointDiagram {
  std::string x_label, y_label;
  bool log_x = false;
  std::vector<std::vector<double>> x, y;  ///< of each line
};

struct PointPlot {
  std::string title;
  std::vector<PointLine> lines;
  std::vector<PointDiagram> diagrams;  ///< two in a row
};

/// Draws into `picture` (.svg or .png); errors as for run_gnuplot. No line is an Error (wrong_input).
void draw(const PointPlot& plot, const std::filesystem::path& picture);

}  // namespace talus::output
