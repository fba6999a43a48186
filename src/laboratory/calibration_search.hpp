// SPDX-License-Identifier: MIT
#pragma once
// One search for the parameters that fit best, by Ceres; and what the curves say of them there.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "laboratory/calibration_model.hpp"

namespace talus::laboratory {

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

}  // namespace talus::laboratory
