// SPDX-License-Identifier: MIT
#pragma once
// `talus calibrate`: the calibration of a case, and the files of its results.

#include <filesystem>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "laboratory/calibration.hpp"

namespace talus::laboratory {

struct CalibrationRun {
  std::filesystem::path folder;            ///< folder of calibration/ and point/
  std::vector<input::Override> overrides;  ///< with which `loaded` was read
  CalibrationOptions options;
  std::string pictures = "svg";  ///< of the element tests: "svg" or "png"
};

/// Calibrates, and writes into folder/calibration: parameters.csv, correlation.csv, curves.csv, solver.txt, and
/// calibration.json last; before them folder/point with the element tests of the case with the fitted parameters.
/// Returns the content of calibration.json. Throws Error (wrong_input) if the case has no calibration, what
/// calibrate() throws, and Error (cannot_write).
results::Calibration run_calibration(const input::LoadedCase& loaded, const CalibrationRun& run);

/// Formats a short summary for the terminal.
std::string write_calibration_digest(const results::Calibration& calibration);

}  // namespace talus::laboratory
