// SPDX-License-Identifier: MIT
#pragma once
// `talus calibrate`: least-squares fit of soil parameters to measured curves, with bounds.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "input/case/case.hpp"
#include "input/read.hpp"
#include "laboratory/calibration_model.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// Name of the abscissa of monitors.
inline constexpr const char* time_axis = "time";

/// Returns warnings on a calibration, the most serious first. `unfixed`: directions in the ranges of the parameters
/// along which no curve changes; `freedom`: measured values less free parameters.
std::vector<std::string> list_findings(const input::Calibration& calibration, const results::Calibration& result,
                                       const std::vector<std::vector<double>>& unfixed, double freedom);

// One search for the best parameters by Ceres, and the accuracy to which the curves determine them.

struct SearchOptions {
  int iterations = 50, threads = 1;
  /// Called after every iteration with its number and the misfit.
  std::function<void(int, double)> watch;
  /// Called with all valid places that were tried, and their misfit.
  std::function<void(const std::vector<double>&, double)> tried;
};

struct Search {
  results::CalibrationSearch summary;
  std::vector<double> places;  ///< final places of the parameters in their ranges, 0 … 1
  long evaluations = 0;
  std::string log;
};

/// Throws Error (wrong_input) if the places `from` are invalid, and Error (interrupted).
Search search(const CalibrationModel& model, const std::vector<double>& from, const SearchOptions& options);

/// Accuracy to which the residuals determine the parameters. Places at 0 and 1 are fixed there.
struct Certainty {
  std::vector<std::vector<double>> covariance;  ///< of places, for residuals of variance 1; zero rows for fixed ones
  std::vector<std::vector<double>> unfixed;  ///< directions without an effect; if there are any, `covariance` is empty
  long evaluations = 0;
};
Certainty find_certainty(const CalibrationModel& model, const std::vector<double>& places, int threads);

struct CalibrationOptions {
  int threads = default_threads();  ///< results do not depend on it
  Progress* progress = nullptr;
  EvaluationStore* store = nullptr;  ///< of the evaluations; nullptr: an interruption loses them
};

/// Fits the parameters of data.calibration. Parameters are in the units of the soils and curves in SI; display values,
/// title, seed and seconds are not set. `log` receives the full report of the solver for the best search. Throws Error
/// (wrong_input) if the initial parameters are invalid or a test cannot be run with them, and Error (interrupted),
/// which states the best parameters so far.
results::Calibration calibrate(const input::Case& data, const CalibrationOptions& options = {},
                               std::string* log = nullptr);

// `talus calibrate`: the calibration of a case, and the files of its results.

struct CalibrationRun {
  std::filesystem::path folder;            ///< folder of calibration/ and point/
  std::vector<input::Override> overrides;  ///< with which `loaded` was read
  CalibrationOptions options;
  std::string pictures = "svg";  ///< of the element tests: "svg" or "png"
  bool resume = false;           ///< use the evaluations of an interrupted search in folder/calibration
};

/// Calibrates, and writes into folder/calibration: parameters.csv, correlation.csv, curves.csv, solver.txt, and
/// calibration.json last; before them folder/point with the element tests of the case with the fitted parameters, and
/// folder with its stages of construction, without factors.
/// Returns the content of calibration.json. Throws Error (wrong_input) if the case has no calibration, what
/// calibrate() throws, Error (folder_exists) where the stages would replace a run, and Error (cannot_write); a folder
/// that cannot be used is refused before the search. What ends the tests or the stages leaves folder/calibration.
/// Every evaluation is stored in folder/calibration/evaluations.jsonl as it is made.
results::Calibration run_calibration(const input::LoadedCase& loaded, const CalibrationRun& run);

/// Formats a short summary for the terminal.
std::string write_calibration_digest(const results::Calibration& calibration);

}  // namespace talus::laboratory
