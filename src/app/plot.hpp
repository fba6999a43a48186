// SPDX-License-Identifier: MIT
#pragma once
// Options of `talus plot`, and its pictures of fields and of soil-water curves.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/case_options.hpp"
#include "results/run.hpp"

namespace talus::app {

struct PlotOptions {
  std::filesystem::path folder;
  std::string field;
  std::string frame = "last";
  std::optional<double> time;
  std::string format;
  std::filesystem::path out;
  bool logarithmic = false;
  std::vector<std::string> sets;  ///< changes to a case, key=value

  /// Returns the file of a picture; a `large` one is PNG by default.
  std::filesystem::path choose_picture(const std::string& stem, bool large) const;
};

/// Draws the requested field of a frame in the units of `run`, and prints the name of the picture. Throws Error
/// (wrong_input) if there is no such field or frame, and what output::ResultsReader and output::draw throw.
void draw_field(const PlotOptions& options, const results::RunResult& run);

/// Draws the soil-water curves of every soil with pore water into `picture`, and writes their numbers beside it as
/// .csv. By default the picture is the name of the case with _soil_water, in the current folder, in `format` ("svg",
/// "png"). Prints both names. Throws Error (wrong_input) for a case without pore water.
void plot_soil_water(const CaseOptions& input, const std::filesystem::path& picture, const std::string& format);

}  // namespace talus::app
