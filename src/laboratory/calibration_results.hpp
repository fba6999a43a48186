#pragma once
// What is kept of a calibration: tables, and what calibration.json says.

#include <string>

#include "laboratory/calibration.hpp"

namespace talus::laboratory {

/// The fitted value as --set takes it, in the unit of the key.
std::string write_value(const FittedParameter& parameter);

/// Comma-separated texts. Values of parameters are in the units of their keys, of curves in per cent and `stress_unit`.
std::string write_parameter_table(const CalibrationResult& result);
std::string write_correlation_table(const CalibrationResult& result);
std::string write_curve_table(const CalibrationResult& result, const std::string& stress_unit);

/// The whole result, in the same units; without title, seed and seconds.
results::Calibration describe_calibration(const CalibrationResult& result, const std::string& stress_unit);

}  // namespace talus::laboratory
