// SPDX-License-Identifier: MIT
#pragma once
// A number that changes with time.

#include <vector>

namespace talus::input {

/// Linear between rows, constant before the first and after the last. Two rows at one time are a jump, whose second
/// value holds from then on.
struct TimeTable {
  std::vector<double> time;   ///< [s], increasing
  std::vector<double> value;  ///< same length as `time`
  /// Value at time `t` [s]; 1 when the table is empty.
  double at(double t) const;
};

}  // namespace talus::input
