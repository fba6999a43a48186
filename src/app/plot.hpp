// SPDX-License-Identifier: MIT
#pragma once
// What `talus plot` is asked for, and its pictures of fields.

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

  /// The file of a picture; a `large` one is PNG by default.
  std::filesystem::path choose_picture(const std::string& stem, bool large) const;
};

/// Draws the asked field of a frame in the units of `run`, and prints the picture's name. Throws Error (wrong_input)
/// where there is no such field or frame; others as output::ResultsReader and output::draw.
void draw_field(const PlotOptions& options, const results::RunResult& run);

// `talus plot CASE`: the soil-water curves of a case.

/// Draws the curves of every soil with pore water into `picture`, and writes their numbers beside it as .csv. By
/// default the picture is the case's name with _soil_water, in the current folder, in `format` ("svg", "png"). Prints
/// both names. Throws Error (wrong_input) for a case without pore water.
void plot_soil_water(const CaseOptions& input, const std::filesystem::path& picture, const std::string& format);

}  // namespace talus::app
