// SPDX-License-Identifier: MIT
#pragma once
// Series in time that stand in files: rain of a weather station, levels of a gauge.

#include <string>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Reads the rows of every series that names a file, relative to the folder of the case file `file`, and the length of
/// a timeline that ends at a date. What is wrong with them goes to `findings`.
///
/// A table has a column `date`, or `time` with its unit, and the columns that the series name, with their units. What
/// is an amount where a rate is wanted, such as rain in mm, falls evenly from the time of its row to that of the next;
/// the last row lasts as long as the one before.
void load_series(Case& data, const std::string& file, Findings& findings);

}  // namespace talus::input
