// SPDX-License-Identifier: MIT
#pragma once
// Series in time that stand in files: rain of a weather station, levels of a gauge.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

// Comma-separated text whose header names columns and units.

/// A table as it is written. Columns are separated by commas, semicolons (then a comma may be the decimal sign) or
/// tabs; lines that begin with # are skipped.
class TextTable {
 public:
  /// A column of the header: "axial_strain [%]".
  struct Heading {
    std::string name, unit;
  };

  /// Throws Error (wrong_input) with one sentence when there is no such file, or none that can be read.
  explicit TextTable(const std::filesystem::path& path);

  const std::string& file() const { return file_; }
  const std::vector<Heading>& header() const { return header_; }
  std::size_t rows() const { return rows_.size(); }

  bool has_column(const std::string& name) const;
  /// The number of a column. Throws Error (wrong_input) with one sentence, which names what is near, when it is absent.
  std::size_t find_column(const std::string& name) const;
  /// Empty where the row ends before the column.
  std::string cell(std::size_t row, std::size_t column) const;
  /// The number in a cell. Throws Error (wrong_input) with one sentence that names file and line when it holds none.
  double number(std::size_t row, std::size_t column) const;
  /// "station.csv:12", for sentences.
  std::string place(std::size_t row) const;

 private:
  /// A row in the text, and its line from 1.
  struct Row {
    std::size_t begin = 0, size = 0;
    int line = 0;
  };

  void read_header(std::string_view line);

  std::string file_;
  std::string text_;  ///< cells are cut out of it when they are asked for
  char separator_ = 0;
  std::vector<Heading> header_;
  std::vector<Row> rows_;
};

// Missing values and missing rows of measured series.

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

/// Reads the rows of every series that names a file, relative to the folder of the case file `file`, and the length of
/// a timeline that ends at a date. What is wrong with them goes to `findings`.
///
/// A table has a column `date`, or `time` with its unit, and the columns that the series name, with their units. What
/// is an amount where a rate is wanted, such as rain in mm, falls evenly from the time of its row to that of the next;
/// the last row lasts as long as the one before.
void load_series(Case& data, const std::string& file, Findings& findings);

}  // namespace talus::input
