// SPDX-License-Identifier: MIT
#pragma once
// Series in time from files, such as rain of a weather station or levels of a gauge.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/text_table.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

// Missing values and missing rows of measured series.

/// Returns true for a cell without a measurement: empty, a word such as NaN or NA, or a code of nines such as -999 or
/// -9999. Codes are at most `code`: a suction of -99 kPa is a measurement, rain of -99 mm is not.
bool is_missing(const std::string& cell, double code);

/// A column with its gaps.
struct MeasuredColumn {
  std::vector<double> times;                  ///< [s]
  std::vector<std::optional<double>> values;  ///< std::nullopt: missing
  std::vector<std::size_t>
      rows;  ///< row numbers in the table, for messages; a missing row has that of the preceding row
};

/// Inserts missing rows, without values, if at least four fifths of the intervals are equal.
void add_missing_rows(MeasuredColumn& column);

/// Returns all values, with missing ones filled by `fill`: "zero", "previous" or "linear". Throws Error (wrong_input)
/// with the first missing place if `fill` is empty or there is no value to fill from. `note` receives a sentence on the
/// filled values.
std::vector<double> fill_missing(const TextTable& table, const std::string& name, const std::string& fill,
                                 const MeasuredColumn& column, std::string& note);

/// Reads the rows of every series that names a file, with paths relative to the folder of the case file `file`, and
/// converts dates of a timeline to times. Faults are added to `findings`.
///
/// A table has a column `date`, or `time` with its unit, and the columns that the series name, with their units.
/// Amounts where a rate is wanted, such as rain in mm, are distributed evenly from the time of their row to that of the
/// next; the last interval is as long as the one before.
void load_series(Case& data, const std::string& file, Findings& findings);

}  // namespace talus::input
