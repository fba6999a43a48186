#pragma once
// `talus calibrate`: parameters of soils from measured curves, by least squares between bounds.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "input/case/case.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

using results::AtLimit;

struct FittedParameter {
  std::string key, unit;
  double factor = 1;  ///< one `unit` in that of the numbers below
  double start = 0, value = 0, low = 0, high = 0;
  std::optional<double> error;  ///< standard error; nothing at a limit, and where the curves do not fix the parameter
  AtLimit limit = AtLimit::no;
};

struct FittedCurve {
  std::string test, x, y;
  std::vector<double> at, measured, before, fitted;  ///< abscissae; ordinates measured, with `start` and fitted [SI]
  std::vector<std::array<double, 2>> line, line_before;  ///< the calculated curves themselves, thinned [SI]
  double deviation = 0, weight = 1;                      ///< as in the case [SI], [-]
  double rms = 0, rms_before = 0;                        ///< root mean square of the differences [SI]
  double mean = 0;                                       ///< mean difference, calculated minus measured [SI]
  double largest = 0, largest_at = 0;                    ///< the largest difference, with its sign, and where [SI]
  double missing = 0;  ///< mean share of the abscissae that the test does not reach [-]
};

/// One of the searches.
struct CalibrationStart {
  std::vector<double> from, to;  ///< values of the parameters
  double misfit = 0;             ///< half the sum of the squares at the end [-]
  double misfit_before = 0;
  bool converged = false;
  int iterations = 0;
  std::string message;  ///< of the solver
};

struct CalibrationResult {
  std::vector<FittedParameter> parameters;
  std::vector<FittedCurve> curves;
  std::vector<CalibrationStart> starts;
  std::size_t best = 0;                                         ///< of the starts
  std::vector<std::vector<std::optional<double>>> correlation;  ///< nothing where an error is missing
  std::size_t values = 0;                                       ///< measured values that were fitted
  double scatter = 0;                 ///< root of the sum of squares over values less free parameters [-]
  long evaluations = 0, tests = 0;    ///< sets of parameters, and tests that were run for them
  std::vector<std::string> findings;  ///< sentences on what to distrust
  std::string log;                    ///< the solver's full report of the best search
};

struct CalibrationOptions {
  int threads = default_threads();  ///< results do not depend on it
  Progress* progress = nullptr;
};

/// Fits the parameters of data.calibration. Throws Error (wrong_input) when the parameters at the start are refused by
/// the case or a test cannot be run with them, and Error (interrupted).
CalibrationResult calibrate(const input::Case& data, const CalibrationOptions& options = {});

}  // namespace talus::laboratory
