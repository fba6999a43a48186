// SPDX-License-Identifier: MIT
#pragma once
// Comma-separated text whose header names columns and units.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::input {

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

}  // namespace talus::input
