// SPDX-License-Identifier: MIT
#pragma once
// Conversion between numbers and texts, independent of the locale and its decimal sign: coordinates with all digits,
// results with the digits that their uncertainty allows.

#include <fmt/format.h>
#include <locale.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
inline double read_number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  double value = std::numeric_limits<double>::quiet_NaN();
  parse_number(text.data(), text.data() + text.size(), value);
  return value;
}

/// Returns `value` rounded to `digits` significant digits, which removes conversion errors such as 29.999999999999996°.
inline double round_to_digits(double value, int digits) {
  return std::isfinite(value) ? read_number(fmt::format("{:.{}g}", value, digits)) : value;
}

/// Writes `x` [m] rounded to 1e-5 m: "12.345", "4000012.5".
inline std::string format_coordinate(double x) {
  return fmt::format("{:.15g}", std::round(x * 1e5) / 1e5 + 0.0);
}

/// Writes two or three coordinates [m]: "(12.345, 4000012.5)".
template <class Point>
std::string format_point(const Point& point) {
  std::string text;
  for (const double x : point) text += (text.empty() ? "(" : ", ") + format_coordinate(x);
  return text + ")";
}

/// Writes "1.3 ± 0.4", "130 ± 20" or "1.31 ± 0.12": the uncertainty has one digit, or two if the first is 1, and the
/// value ends at the same digit. Without an uncertainty the value has two digits; with an uncertainty below 1/1000 of
/// the value it has three. Numbers below `least` are written as zero, non-finite values as "–".
inline std::string format_uncertain(double value, std::optional<double> uncertainty) {
  constexpr double least = 1e-9;
  const auto round_at = [](double x, double last) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(last) + 1e-9)));
    return fmt::format("{:.{}f}", std::round(x / last) * last + 0.0, decimals);
  };
  const auto find_first = [](double x) { return std::pow(10, std::floor(std::log10(std::abs(x)))); };
  if (!std::isfinite(value) || (uncertainty && !std::isfinite(*uncertainty))) return "–";
  const bool is_zero = std::abs(value) < least, is_exact = uncertainty && *uncertainty < least;
  if (is_zero && (!uncertainty || is_exact)) return "0";
  if (!uncertainty) return round_at(value, 0.1 * find_first(value));
  if (is_exact || *uncertainty < 1e-3 * std::abs(value)) return round_at(value, 0.01 * find_first(value));
  double last = find_first(*uncertainty);
  if (*uncertainty < 1.95 * last) last /= 10;
  return round_at(value, last) + " ± " + round_at(*uncertainty, last);
}

}  // namespace talus
