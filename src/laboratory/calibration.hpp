// SPDX-License-Identifier: MIT
#pragma once
// `talus calibrate`: parameters of soils from measured curves, by least squares between bounds.

#include <string>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "input/case/case.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

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
