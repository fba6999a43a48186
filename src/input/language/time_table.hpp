// SPDX-License-Identifier: MIT
#pragma once
// A number that changes with time.

#include <optional>
#include <string>
#include <vector>

namespace talus::input {

/// The columns of a file that the rows of a TimeTable are.
struct SeriesFile {
  std::string file;    ///< as given: relative to the case file
  std::string column;  ///< of the value
  std::string minus;   ///< of what is taken off it; empty: nothing
  std::string fill;    ///< for missing values and rows: "zero", "previous" or "linear"; empty: they are refused
};

/// Linear between rows, constant before the first and after the last. Two rows at one time are a jump, whose second
/// value holds from then on.
struct TimeTable {
  std::vector<double> time;            ///< [s], increasing
  std::vector<double> value;           ///< same length as `time`
  std::optional<SeriesFile> source{};  ///< where the rows are; they are not read yet
  /// Value at time `t` [s]; 1 when the table is empty.
  double at(double t) const;
};

}  // namespace talus::input
