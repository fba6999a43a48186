// SPDX-License-Identifier: MIT
#pragma once
// Series in time from files, such as rain of a weather station or levels of a gauge.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

// Delimited text whose header has the names and units of the columns.

/// A table as text. Columns are separated by commas, semicolons (then a comma may be the decimal separator) or tabs;
/// lines that begin with # are skipped.
class TextTable {
 public:
  /// A column of the header: "axial_strain [%]".
  struct Heading {
    std::string name, unit;
  };

  /// Throws Error (wrong_input) with one sentence if the file does not exist or cannot be read.
  explicit TextTable(const std::filesystem::path& path);

  const std::string& file() const { return file_; }
  const std::vector<Heading>& header() const { return header_; }
  std::size_t rows() const { return rows_.size(); }

  bool has_column(const std::string& name) const;
  /// Returns the index of a column. Throws Error (wrong_input) with one sentence, which suggests a similar name, if it
  /// is absent.
  std::size_t find_column(const std::string& name) const;
  /// Returns the text of a cell; empty if the row ends before the column.
  std::string cell(std::size_t row, std::size_t column) const;
  /// Returns the number in a cell. Throws Error (wrong_input) with one sentence that names file and line if it is not a
  /// number.
  double number(std::size_t row, std::size_t column) const;
  /// Returns the place of a row for messages: "station.csv:12".
  std::string place(std::size_t row) const;

 private:
  /// Position of a row in the text, and its line number from 1.
  struct Row {
    std::size_t begin = 0, size = 0;
    int line = 0;
  };

  void read_header(std::string_view line);

  std::string file_;
  std::string text_;  ///< cells are extracted from it on access
  char separator_ = 0;
  std::vector<Heading> header_;
  std::vector<Row> rows_;
};

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
