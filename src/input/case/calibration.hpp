#pragma once
// [calibration] of the case: which numbers of the soils `talus calibrate` fits, and to what.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "input/language/amount.hpp"

namespace talus::input {

enum class CalibrationScale { linear, log };

struct CalibrationParameter {
  std::string key;              ///< dotted path as for --set: "materials.loess.kappa"
  std::optional<Amount> start;  ///< by default what the case has
  Amount min, max;
  CalibrationScale scale = CalibrationScale::linear;
  // What follows, in the unit in which the material keeps it (number_keys.hpp).
  std::string material, path;  ///< "loess" and "kappa"
  std::string unit;            ///< as people write it; empty: none
  double factor = 1;           ///< of that unit in the material's
  double first = 0, low = 0, high = 0;
};

/// Points of a test as a laboratory measured them.
struct MeasuredCurve {
  std::string test;
  std::string file;                         ///< table, relative to the case; or
  std::vector<std::array<double, 2>> data;  ///< rows, in the units below
  std::string x, y;                         ///< quantities of list_point_quantities()
  std::string x_unit, y_unit;               ///< of `data`; empty: kPa or none
  double weight = 1;                        ///< [-]; 0: shown, not fitted
  std::optional<Amount> error;              ///< standard error of y: in per cent of its largest value, or an amount
  // What follows.
  std::size_t test_number = 0;
  std::vector<std::array<double, 2>> points;  ///< in the order of the measurement [SI]
  double deviation = 0;                       ///< standard error of y [SI]
};

struct Calibration {
  int starts = 5;       ///< solutions from as many starting points
  int seed = 1;         ///< of their random choice
  int iterations = 50;  ///< of each at most
  std::vector<CalibrationParameter> parameters;
  std::vector<MeasuredCurve> curves;
};

}  // namespace talus::input
