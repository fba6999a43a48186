// SPDX-License-Identifier: MIT
#pragma once
// Quantities with units by UDUNITS-2, and calendar dates. UDUNITS is not thread-safe, so every call is serialised by a
// lock.

#include <optional>
#include <string>
#include <string_view>

namespace talus::units {

/// A number and its unit as in a case file: "45 MPa" is {45, "MPa"}.
struct Quantity {
  double value = 0;
  std::string unit;
};

/// Writes the message on a decimal comma such as "2,5 kPa", with the correct form.
std::string explain_decimal_comma(const std::string& text);

/// Splits "45 MPa" into number and unit. Throws Error (wrong_input) if the text does not begin with a finite number, or
/// if there is no unit.
Quantity parse_quantity(const std::string& text);

/// Returns the factor of `unit` to the SI unit of its dimension: 1000 for "kPa", π/180 for "deg", 1 for "" (a plain
/// number). Throws Error (wrong_input) for an unknown unit, with a suggestion if a similar one exists.
double get_si_factor(const std::string& unit);

/// Returns the quantity `text`, which must have the dimension of `wanted`, in the SI unit. `subject` is the name of the
/// quantity ("cohesion") in the error: "'2 kg' is a mass; cohesion needs a stress such as "2 kPa"".
double parse_as_si(const std::string& text, const std::string& wanted, std::string_view subject);

/// Returns the dimension of a unit with its article, "a stress" for "kPa"; "a number" for "", and "a quantity in X" for
/// a dimension without a name.
std::string get_dimension_name(const std::string& unit);

/// Returns an example of a quantity of the unit's dimension: "2 kPa" for every unit of stress.
std::string get_dimension_example(const std::string& unit);

/// Formats a time in a convenient unit: "90 s", "12.5 min", "6 h", "3 days".
std::string format_time(double seconds);

}  // namespace talus::units

namespace talus {

// Calendar dates without time zones or summer time: every day has 86,400 s.

/// Returns the seconds from the start of 1970 to "2023-07-01", "2023-07-01 06:00" or "2023-07-01T06:00:30";
/// std::nullopt if the text is not a date.
std::optional<double> parse_date(const std::string& text);

/// Formats "2023-07-01", with " 06:00" unless it is midnight, to the nearest minute.
std::string format_date(double seconds);

}  // namespace talus
