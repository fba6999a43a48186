// SPDX-License-Identifier: MIT
#pragma once
// `talus calibrate`: parameters of soils from measured curves, by least squares between bounds.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "input/case/case.hpp"
#include "laboratory/calibration_model.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

// What to distrust in a calibration, in sentences.

/// `unfixed`: directions in the ranges of the parameters along which no curve changes; `freedom`: measured values less
/// free parameters. The most serious comes first.
std::vector<std::string> list_findings(const input::Calibration& calibration, const results::Calibration& result,
                                       const std::vector<std::vector<double>>& unfixed, double freedom);

// One search for the parameters that fit best, by Ceres; and what the curves say of them there.

struct SearchOptions {
  int iterations = 50, threads = 1;
  /// Called after every iteration with its number and the misfit.
  std::function<void(int, double)> watch;
};

struct Search {
  results::CalibrationSearch summary;
  std::vector<double> places;  ///< at which it ended, of the parameters in their ranges, 0 … 1
  long evaluations = 0;
  std::string log;
};

/// Throws Error (wrong_input) when the model refuses the places `from`, and Error (interrupted).
Search search(const CalibrationModel& model, const std::vector<double>& from, const SearchOptions& options);

/// How well the residuals fix the parameters. Places at 0 and 1 are held there.
struct Certainty {
  std::vector<std::vector<double>> covariance;  ///< of places, for residuals of variance 1; zero rows where held
  std::vector<std::vector<double>> unfixed;     ///< directions along which nothing changes; then `covariance` is empty
  long evaluations = 0;
};
Certainty find_certainty(const CalibrationModel& model, const std::vector<double>& places, int threads);

struct CalibrationOptions {
  int threads = default_threads();  ///< results do not depend on it
  Progress* progress = nullptr;
};

/// Fits the parameters of data.calibration. Parameters are in the units in which the soils keep them and curves in SI;
/// what people read, and title, seed and seconds, are missing. `log` gets the solver's full report of the best search.
/// Throws Error (wrong_input) when the parameters at the start are refused by the case or a test cannot be run with
/// them, and Error (interrupted).
results::Calibration calibrate(const input::Case& data, const CalibrationOptions& options = {},
                               std::string* log = nullptr);

}  // namespace talus::laboratory
