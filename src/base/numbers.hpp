// SPDX-License-Identifier: MIT
#pragma once
// Numbers in sentences: coordinates with all digits, so that those of a map name a place; others with as many digits as
// their uncertainty leaves.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace talus {

/// "12.345", "4000012.5": `x` [m] rounded to 1e-5 m.
inline std::string format_coordinate(double x) {
  return fmt::format("{:.15g}", std::round(x * 1e5) / 1e5 + 0.0);
}

/// "(12.345, 4000012.5)" of two or three coordinates [m].
template <class Point>
std::string format_point(const Point& point) {
  std::string text;
  for (const double x : point) text += (text.empty() ? "(" : ", ") + format_coordinate(x);
  return text + ")";
}

/// "1.3 ± 0.4", "130 ± 20", "1.31 ± 0.12": the uncertainty has one digit, or two that begin with 1, and the value ends
/// where it does. Without an uncertainty "1.3", with two digits; with one below a thousandth of the value, three.
/// Numbers below `least` are rounding, and zero. "–" for a value that is not finite.
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
