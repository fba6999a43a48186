// SPDX-License-Identifier: MIT
#pragma once
// Missing values and missing rows of measured series.

#include <optional>
#include <string>
#include <vector>

#include "input/case/text_table.hpp"

namespace talus::input {

/// True for a cell without a measurement: it is empty, a word such as NaN or NA, or a code of nines such as -999 or
/// -9999. Codes are at most `code`: suctions of -99 kPa are measured, rain of -99 mm is not.
bool is_missing(const std::string& cell, double code);

/// A column of a table as it is filled.
struct MeasuredColumn {
  std::vector<double> times;                  ///< [s]
  std::vector<std::optional<double>> values;  ///< nothing: missing
  std::vector<std::size_t> rows;              ///< of the table, for its places; a missing row has the one before it
};

/// Adds the rows that are missing where at least four fifths of the others are equally spaced, without values.
void add_missing_rows(MeasuredColumn& column);

/// All values, those that are missing filled by `fill`: "zero", "previous" or "linear". Without a word, and where it
/// finds nothing to fill from, throws Error (wrong_input) with the first place. `note` receives a sentence on what was
/// filled.
std::vector<double> fill_missing(const TextTable& table, const std::string& name, const std::string& fill,
                                 const MeasuredColumn& column, std::string& note);

}  // namespace talus::input
