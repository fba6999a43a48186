// SPDX-License-Identifier: MIT
#pragma once
// A number as a function of time.

#include <optional>
#include <string>
#include <vector>

namespace talus::input {

/// Source of the rows of a TimeTable in a file.
struct SeriesFile {
  std::string file;    ///< as given, relative to the case file
  std::string column;  ///< column of the value
  std::string minus;   ///< column that is subtracted; empty: none
  std::string fill;    ///< method for missing values and rows: "zero", "previous" or "linear"; empty: they are rejected
};

/// Linear between rows, constant before the first and after the last. Two rows at one time are a jump, and the second
/// value applies from then on.
struct TimeTable {
  std::vector<double> time;            ///< [s], non-decreasing
  std::vector<double> value;           ///< same length as `time`
  std::optional<SeriesFile> source{};  ///< source of rows that are not read yet
  /// Returns the value at time `t` [s]; 1 if the table is empty.
  double at(double t) const;
};

}  // namespace talus::input
