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

void describe(auto& v, CalibrationParameter& p) {
  v.key("key", p.key, plain().required().example(R"("materials.sand.young_modulus")"),
        "The number of a material that is fitted, written as for --set. A test that sets it keeps its own value.");
  v.key("min", p.min, plain().required().example("5000"),
        "Its smallest value: a number in the unit of the key, or a text with a unit.");
  v.key("max", p.max, plain().required().example(R"("80 MPa")"), "Its largest value.");
  v.key("start", p.start, plain().example("20000"),
        "Where the search begins; if not given, at the value that the material has.");
  v.key("scale", p.scale, plain(), "How the search moves between the smallest and the largest value.");
}

void describe(auto& v, MeasuredCurve& c) {
  v.key("test", c.test, plain().required().example(R"("cell 100 kPa")"), "Name of the [[test]] that was measured.");
  v.key("x", c.x, plain().required().example(R"("axial_strain")"),
        "Abscissa, a column of the tables of `talus point`: axial_strain, axial_stress, p, suction …");
  v.key("y", c.y, plain().required().example(R"("q")"),
        "Ordinate, whose differences are made small: q, volumetric_strain, void_ratio …");
  v.key("file", c.file, plain().example(R"("measured/cell_100.csv")"),
        "Table with a column for x and one for y, headed with their names and units, such as `axial_strain [%],q "
        "[kPa]`; relative to the case file. Rows are in the order of the measurement.");
  v.key("data", c.data, plain().needed_without("file", !c.file.empty()).example("[[0.05, 165.1], [0.1, 226.2]]"),
        "The rows themselves, [[x, y], ...].");
  v.key("x_unit", c.x_unit, plain().allowed_without("file", !c.file.empty()).example(R"("%")"),
        "Unit of x in `data`; if not given, kPa for stresses and none for the rest.");
  v.key("y_unit", c.y_unit, plain().allowed_without("file", !c.file.empty()).example(R"("MPa")"),
        "Unit of y in `data`, in the same way.");
  v.key("error", c.error, plain().above(0).example(R"("3 kPa")"),
        "Standard error of the measured y: in per cent of the largest measured value, or an amount. If not given, 1 %. "
        "Differences are divided by it.");
  v.key("weight", c.weight, plain().at_least(0),
        "Factor of the differences of this curve; 0: the curve is shown and not fitted.");
}

void describe(auto& v, MonitoredCurve& c) {
  v.key("name", c.monitor, plain().required().example(R"("plate")"),
        "Name of an [[output.monitor]] with measured values, in a case with stages of construction.");
  v.key("quantity", c.quantity, plain(), "Which of its measured values count.");
  v.key("error", c.error, plain().above(0).example(R"("5 mm")"),
        "Standard error of a measured value: in per cent of the largest one, or an amount with its unit. If not given, "
        "1 %.");
  v.key("weight", c.weight, plain().at_least(0),
        "Factor of the differences of these values; 0: they are shown and not fitted.");
}

void describe(auto& v, Calibration& c) {
  v.key(
      "starts", c.starts, plain().at_least(1).at_most(1000),
      "Number of searches: one from `start`, the others from random values between `min` and `max`. The best counts.");
  v.key("seed", c.seed, plain().at_least(0), "Seed of the random values; equal seeds give equal results.");
  v.key("iterations", c.iterations, plain().at_least(1), "Largest number of iterations of each search.");
  v.tables("parameter", c.parameters, 0, "A number that is fitted.");
  v.tables("curve", c.curves, 0, "A measured curve of an element test.");
  v.tables("monitor", c.monitors, 0,
           "Measured values of a monitor in stages of construction, in the place of a curve.");
}

}  // namespace talus::input
