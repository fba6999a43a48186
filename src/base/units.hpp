// SPDX-License-Identifier: MIT
#pragma once
// Quantities with units, through UDUNITS-2. UDUNITS is not thread safe, so every call takes one lock.

#include <optional>
#include <string>
#include <string_view>

namespace talus::units {

/// A number and the unit behind it, as a user writes it: "45 MPa" is {45, "MPa"}.
struct Quantity {
  double value = 0;
  std::string unit;
};

/// What is wrong with "2,5 kPa", and how it is written here.
std::string explain_decimal_comma(const std::string& text);

/// Splits "45 MPa" into its number and its unit. Throws Error (wrong_input) when the text does not begin with a finite
/// number, or when no unit follows it.
Quantity parse_quantity(const std::string& text);

/// What one `unit` is in the SI unit of its dimension: 1000 for "kPa", π/180 for "deg", 1 for "" (a plain number).
/// Throws Error (wrong_input) for a unit that UDUNITS does not know, with a suggestion where one is near.
double get_si_factor(const std::string& unit);

/// Reads the quantity string `text` as a quantity of the same dimension as `wanted` and returns it in the SI unit.
/// `subject` names what is read ("cohesion") in the error: "'2 kg' is a mass; cohesion needs a stress such as "2 kPa"".
double parse_as_si(const std::string& text, const std::string& wanted, std::string_view subject);

/// The dimension of a unit with its article, "a stress" for "kPa"; "a number" for "", and "a quantity in X" for a
/// dimension that has no name here.
std::string get_dimension_name(const std::string& unit);

/// A quantity of the unit's dimension as a user would write it: "2 kPa" for every unit of stress.
std::string get_dimension_example(const std::string& unit);

/// A time as people say it: "90 s", "12.5 min", "6 h", "3 days".
std::string format_time(double seconds);

}  // namespace talus::units

namespace talus {

// Dates of the calendar, without time zones or summer time: every day has 86,400 s.

/// Seconds from the start of 1970 to "2023-07-01", "2023-07-01 06:00" or "2023-07-01T06:00:30"; nothing where the text
/// is no date.
std::optional<double> parse_date(const std::string& text);

/// "2023-07-01", with " 06:00" where it is not midnight, to the nearest minute.
std::string format_date(double seconds);

}  // namespace talus
