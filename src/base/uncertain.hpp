// SPDX-License-Identifier: MIT
#pragma once
// Numbers in sentences with as many digits as their uncertainty leaves.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace talus {

/// "1.3 ± 0.4", "130 ± 20", "1.31 ± 0.12": the uncertainty has one digit, or two that begin with 1, and the value ends
/// where it does. Without an uncertainty "1.3", with two digits; with one of 0 three.
inline std::string format_uncertain(double value, std::optional<double> uncertainty) {
  const auto round_at = [](double x, double last) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(last) + 1e-9)));
    return fmt::format("{:.{}f}", std::round(x / last) * last + 0.0, decimals);
  };
  if (value == 0 && !(uncertainty.value_or(0) > 0)) return "0";
  if (!uncertainty || !(*uncertainty > 0)) {
    const int digits = uncertainty ? 3 : 2;
    return round_at(value, std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits));
  }
  double last = std::pow(10, std::floor(std::log10(*uncertainty)));
  if (*uncertainty < 1.95 * last) last /= 10;
  return round_at(value, last) + " ± " + round_at(*uncertainty, last);
}

}  // namespace talus
