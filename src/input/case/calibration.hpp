// SPDX-License-Identifier: MIT
#pragma once
// [calibration]: soil parameters that `talus calibrate` fits, and the measured curves.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/point_test.hpp"
#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

// Tables of measured element tests.

/// Returns the quantity of an element test by its name; nullptr if there is none.
const PointQuantity* find_point_quantity(const std::string& name);

/// Returns the factor of `unit` of a measured quantity to SI; 1 for an empty unit. Throws Error (wrong_input) with one
/// sentence if the unit is unknown or of another dimension.
double find_measured_factor(const PointQuantity& quantity, const std::string& unit);

/// Returns the columns `x` and `y` of a TextTable [SI] row by row, without rows in which one of them is empty. Throws
/// Error (wrong_input) with one sentence that names the file and the line.
std::vector<std::array<double, 2>> read_measured_table(const std::filesystem::path& path, const PointQuantity& x,
                                                       const PointQuantity& y);

enum class CalibrationScale { linear, log };

struct CalibrationParameter {
  std::string key;              ///< dotted path as for --set: "materials.loess.kappa"
  std::optional<Amount> start;  ///< default: the value of the case
  Amount min, max;
  CalibrationScale scale = CalibrationScale::linear;
  // Derived, in the unit in which the material stores the key (uncertain_number.hpp):
  std::string material, path;  ///< "loess" and "kappa"
  std::string unit;            ///< for reports; empty: none
  double factor = 1;           ///< one such unit in the unit of the material
  double first = 0, low = 0, high = 0;
};

/// Measured points of a test.
struct MeasuredCurve {
  std::string test;
  std::string file;                         ///< table, path relative to the case file; or
  std::vector<std::array<double, 2>> data;  ///< rows, in the units below
  std::string x, y;                         ///< quantities of list_point_quantities()
  std::string x_unit, y_unit;               ///< of `data`; empty: kPa or none
  double weight = 1;                        ///< [-]; 0: shown, not fitted
  std::optional<Amount> error;              ///< standard error of y: in per cent of its largest value, or an amount
  // Derived:
  std::size_t test_number = 0;
  std::vector<std::array<double, 2>> points;  ///< in the order of the measurement [SI]
  double deviation = 0;                       ///< standard error of y [SI]
};

enum class MonitoredQuantity { settlement, lateral, pressure };

/// Measurements of a monitor in stages of construction.
struct MonitoredCurve {
  std::string monitor;
  MonitoredQuantity quantity = MonitoredQuantity::settlement;
  std::optional<Amount> error;
  double weight = 1;  ///< [-]; 0: shown, not fitted
  // Derived:
  std::size_t number = 0;                     ///< of the monitor
  std::vector<std::array<double, 2>> points;  ///< time [s] and value [SI]
  double deviation = 0;                       ///< standard error of the value [SI]
};

struct Calibration {
  int starts = 5;       ///< number of starting points
  int seed = 1;         ///< of the random starting points
  int iterations = 50;  ///< limit per starting point
  std::vector<CalibrationParameter> parameters;
  std::vector<MeasuredCurve> curves;
  std::vector<MonitoredCurve> monitors;
};

template <>
inline constexpr auto choices<CalibrationScale> = std::array{
    Choice{CalibrationScale::linear, "linear", "equal steps of the number itself"},
    Choice{CalibrationScale::log, "log", "equal steps of its logarithm, for a number whose order is unknown"},
};

template <>
inline constexpr auto choices<MonitoredQuantity> = std::array{
    Choice{MonitoredQuantity::settlement, "settlement", "`measured_settlement`"},
    Choice{MonitoredQuantity::lateral, "lateral", "`measured_lateral`"},
    Choice{MonitoredQuantity::pressure, "pressure", "`measured_pressure`"},
};

void describe(Visitor& v, CalibrationParameter& p);

void describe(Visitor& v, MeasuredCurve& c);

void describe(Visitor& v, MonitoredCurve& c);

void describe(Visitor& v, Calibration& c);

}  // namespace talus::input
