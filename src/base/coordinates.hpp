// SPDX-License-Identifier: MIT
#pragma once
// Coordinates in sentences: all digits down to a hundredth of a millimetre, so that those of a map name a place.

#include <fmt/format.h>

#include <cmath>
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

}  // namespace talus
