// SPDX-License-Identifier: MIT
#pragma once
// Results as tables: rows of numbers and texts below the titles and units of their descriptions.

#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "base/shown_units.hpp"
#include "results/described.hpp"

namespace talus::results {

/// The value of a cell; std::monostate for none, which includes NaN.
using Cell = std::variant<std::monostate, double, bool, std::string>;

struct Column {
  std::string key;        ///< path below the row: "checks.residual"; the members of a point are "points.x", "points.y"
  std::string title;      ///< "checks of admissibility: what is left of forces …"
  std::string unit;       ///< unit of display; empty if there is none
  bool counts = false;    ///< the numbers are integers
  bool is_mixed = false;  ///< the numbers are of several quantities
  std::vector<Cell> cells;
};

/// A list of structs, or a single struct as one row.
struct Table {
  std::string name;        ///< path of keys in the file of results: "lem.critical.slices"; empty for the file itself
  std::string title;       ///< "critical circles: its slices"
  bool is_single = false;  ///< one struct, and not a list
  bool is_head = false;    ///< belongs to the overview of the results: title block, provenance, factors
  std::vector<Column> columns;  ///< each has `rows` cells
  std::size_t rows = 0;
};

/// Returns the unit of display of a stored unit: "kPa" for "Pa". Volumes and flows of a section of 2 dimensions are per
/// unit thickness. Units without a unit of display are unchanged.
ShownUnit find_shown_unit(const std::string& stored, const ShownUnits& units, std::size_t dimension);

/// Returns the tables of a result with its own file, in units of display: one for each struct and each list of structs
/// or points, in the order of their descriptions. A list within the rows of another one is a table whose first columns
/// identify these rows. Columns without a value are left out, as are empty tables, `input`, and the table of a study,
/// which find_study_table() returns.
std::deque<Table> make_tables(Value result, const ShownUnits& units, std::size_t dimension);

struct StudyResult;

/// Returns the table of a study: a row for each variant, in the units of its columns.
Table make_study_table(const StudyResult& study);

}  // namespace talus::results
