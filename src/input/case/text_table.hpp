// SPDX-License-Identifier: MIT
#pragma once
// Delimited text whose header has the names and units of the columns.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::input {

/// A table as text. Columns are separated by commas, semicolons or tabs (then a comma may be the decimal separator) or
/// blanks; a cell in quotation marks may contain the separator. Lines that begin with #, % or // are skipped. If the
/// first line has numbers only, it is a row, and the columns are named 1, 2, ….
class TextTable {
 public:
  /// A column of the header: "axial_strain [%]".
  struct Heading {
    std::string name, unit;
  };

  /// Throws Error (wrong_input) with one sentence if the file does not exist or cannot be read.
  explicit TextTable(const std::filesystem::path& path);
  /// Reads the table in `text`, whose first line has the number `first_line` in `file`. Throws Error (wrong_input) with
  /// one sentence if it cannot be read.
  TextTable(std::string file, std::string text, int first_line);

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

  void read_rows(int first_line);
  void read_header(std::string_view line);
  /// Returns true if the text is a finite number, possibly with a decimal comma.
  bool try_number(std::string text, double& value) const;

  std::string file_;
  std::string text_;  ///< cells are extracted from it on access
  char separator_ = 0;
  bool is_headless_ = false;
  std::vector<Heading> header_;
  std::vector<Row> rows_;
};

}  // namespace talus::input
