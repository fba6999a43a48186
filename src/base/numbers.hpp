// SPDX-License-Identifier: MIT
#pragma once
// Conversion between numbers and texts, independent of the locale and its decimal sign: coordinates with all digits,
// results with the digits that their uncertainty allows.

#include <locale.h>

#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Sets the decimal point for libraries called in this thread, for the lifetime of the object, even if the locale of
/// the process has a decimal comma.
class PlainNumbers {
 public:
  PlainNumbers() : before_(uselocale(get())) {}
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;
  ~PlainNumbers() { uselocale(before_); }

 private:
  static locale_t get() {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    return plain;
  }
  locale_t before_;
};

/// Reads the number that the text [first, last) begins with. Returns the place behind it, or nullptr if there is none
/// or it is out of range.
const char* parse_number(const char* first, const char* last, double& value);

/// Writes the shortest text that reads as the same number.
std::string write_shortest(double value);

/// Returns the number at the beginning of `text`, after blanks; NaN if there is none.
double read_number(std::string_view text);

/// Returns `value` rounded to `digits` significant digits, which removes conversion errors such as 29.999999999999996°.
double round_to_digits(double value, int digits);

/// Writes `value` with `digits` significant digits: "0.01235", "1.2e+06".
std::string format_significant(double value, int digits);

/// Writes `x` [m] rounded to 1e-5 m: "12.345", "4000012.5".
std::string format_coordinate(double x);

/// Writes two or three coordinates [m]: "(12.345, 4000012.5)".
std::string format_point(const auto& point) {
  std::string text;
  for (const double x : point) text += (text.empty() ? "(" : ", ") + format_coordinate(x);
  return text + ")";
}

/// Writes "1.3 ± 0.4", "130 ± 20" or "1.31 ± 0.12": the uncertainty has one digit, or two if the first is 1, and the
/// value ends at the same digit. Without an uncertainty the value has two digits; with an uncertainty below 1/1000 of
/// the value it has three. Numbers below `least` are written as zero, non-finite values as "–".
std::string format_uncertain(double value, std::optional<double> uncertainty);

}  // namespace talus
