// SPDX-License-Identifier: MIT
#pragma once
// Numbers that files need not keep to the last digit.

#include <cmath>

namespace talus::run {

/// `value` to 1/`digits`: digits = 1e6 keeps six digits after the point.
inline double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

}  // namespace talus::run
