// SPDX-License-Identifier: MIT
#pragma once
// A table of a survey, whose columns are recognised by their headings: the points of lines, or boreholes.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/plan_line.hpp"
#include "drawing/survey_headings.hpp"
#include "input/case/text_table.hpp"

namespace talus::drawing {

/// Form of a table.
enum class TableForm {
  lines,    ///< points of a line, or of several lines with their names
  layers,   ///< boreholes with a row for each layer
  holes,    ///< boreholes with a row each, and a column for the depth of each boundary
  collars,  ///< positions of boreholes
};

/// A column with the depth of a lower boundary in a table of form `holes`.
struct DepthColumn {
  std::string soil;
  std::size_t column = 0;
  double factor = 1;  ///< [m]
  bool has_unit = false;
};

class SurveyTable {
 public:
  /// Reads the table of a file, below a preamble if it has one: lines above the headings, such as "Unit: ft". A column
  /// without a unit has lengths in that of the preamble or else in `unit` [m]. Throws Error (wrong_input) with one
  /// sentence if the file cannot be read or its headings are not understood.
  SurveyTable(const std::string& path, double unit);
  /// Reads a table that is part of a file; `name` is that of the part.
  SurveyTable(input::TextTable text, const std::string& name, double unit);

  TableForm form() const { return form_; }
  const std::string& file() const { return text_.file(); }
  /// Number of the first row of values, after a row of units.
  std::size_t first_row() const { return first_row_; }
  std::size_t rows() const { return text_.rows(); }
  bool has(Role role) const { return columns_[static_cast<std::size_t>(role)].has_value(); }
  bool has_position() const { return has(Role::chainage) || has(Role::x); }
  /// Returns true if the positions stand in the table twice: a chainage, and coordinates in plan.
  bool has_both_positions() const { return has_both_positions_; }
  /// Returns the number of a point along its line, in a table with such a column. Throws Error (wrong_input) with file
  /// and line if it is not a number.
  double read_order(std::size_t row) const;
  /// Returns a length [m]; std::nullopt if the table has no such column or the cell is empty. Throws Error
  /// (wrong_input) with file and line if it is not a number.
  std::optional<double> read_length(std::size_t row, Role role) const;
  std::optional<double> read_length(std::size_t row, const DepthColumn& column) const;
  /// Returns the position of a row: its chainage, or x and northing; std::nullopt if a cell is empty.
  std::optional<PlanPlace> read_place(std::size_t row) const;
  /// Returns the heading of the column of a role; empty if the table has none.
  std::string get_heading(Role role) const;
  /// Returns the unit that a column without one of its own takes from the options [m]; otherwise 1.
  double get_assumed_unit(Role role) const;
  /// Returns the text of a cell; empty if the table has no such column.
  std::string read_text(std::size_t row, Role role) const;
  std::string place(std::size_t row) const { return text_.place(row); }
  /// Takes positions of boreholes as the points of a line, if they have elevations.
  void take_as_lines() {
    if (has(Role::elevation)) form_ = TableForm::lines;
  }
  const std::vector<DepthColumn>& depths() const { return depths_; }
  /// Returns true if each column of lengths has a unit, in its heading, in a row of units or by the preamble.
  bool has_units() const;
  /// Returns how the table was understood, in one sentence.
  std::string describe() const;

 private:
  struct Column {
    std::size_t number = 0;
    double factor = 1;  ///< [m]; 0: no length
    bool has_unit = false;
  };

  /// Opens the file at its headings, and takes the unit of the preamble.
  input::TextTable open(const std::string& path, double& unit);
  void read(double unit);
  void select_columns(double unit);
  /// Returns the factor of a column of lengths [m].
  double get_factor(const Heading& heading, double unit) const;
  /// Takes the first of `names` that is a heading of an unused column fit for the role.
  void take_column(Role role, std::span<const char* const> names, double unit);
  /// Takes easting and northing of one kind.
  void take_coordinates(double unit);
  /// Takes unused columns as depths in a table of boreholes, and lists the others.
  void take_depths(double unit);
  void find_form();
  /// Throws Error (wrong_input) for latitudes and longitudes, and for a first line of data in place of headings.
  void refuse_headings() const;
  /// Returns true if the first column of `role` has one of `keys` as heading.
  bool is_headed(Role role, const std::vector<std::string>& keys) const;
  /// Takes the first row as units if it has them in a column of lengths.
  void read_units_row();
  /// Returns the number of a cell; "0+012.5" and "12+50" are stations of 1000 and 100 with what follows them.
  double read_number(std::size_t row, std::size_t column) const;
  bool is_numeric(std::size_t column) const;
  bool has_text(std::size_t column) const;

  std::size_t preamble_ = 0;   ///< number of lines above the headings
  std::string preamble_unit_;  ///< unit of length that they name
  bool is_converted_ = false;  ///< the text was not UTF-8
  bool has_both_positions_ = false;
  std::string part_;  ///< name of the part of the file
  input::TextTable text_;
  TableForm form_ = TableForm::lines;
  std::array<std::optional<Column>, static_cast<std::size_t>(Role::count)> columns_;
  std::vector<Heading> headings_;
  std::vector<char> is_used_;  ///< of the columns
  std::vector<DepthColumn> depths_;
  std::vector<std::string> unused_;
  std::size_t first_row_ = 0;
};

/// Reads the tables of a file: one, or the boreholes and their layers of an AGS file.
std::vector<SurveyTable> read_survey_tables(const std::string& path, double unit);

}  // namespace talus::drawing
